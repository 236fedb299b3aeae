#include "flexkey/timeline/sampling.h"

#include <algorithm>

#include "flexkey/timeline/curve.h"
#include "flexkey/timeline/interpolate.h"
#include "flexkey/timeline/rotation.h"
#include "flexkey/timeline/sway.h"
#include "flexkey/timeline/tangent_turn.h"

namespace flexkey {
namespace {

/// A slope that keeps the cubic monotone between its keys: the weighted harmonic mean of the neighbouring
/// secants, or 0 where they differ in sign (Fritsch and Butland, "A method for constructing local monotone
/// piecewise cubic interpolants", 1984); 0 at the ends, where λ is held outside.
double monotone_slope(const Track<double>& track, std::size_t i) {
  if (i == 0 || i + 1 == track.size()) return 0;
  const double h0 = track[i].time - track[i - 1].time, h1 = track[i + 1].time - track[i].time;
  const double d0 = (track[i].value - track[i - 1].value) / h0,
               d1 = (track[i + 1].value - track[i].value) / h1;
  if (d0 * d1 <= 0) return 0;
  return 3 * (h0 + h1) / ((2 * h1 + h0) / d0 + (h1 + 2 * h0) / d1);
}

Vec3 sample_vector(const Track<Vec3>& track, double time) {
  return interpolate<Vec3>(track, time, [&](std::size_t i) { return track[i].value; });
}

/// Keys with axes of their own: great arcs, or for `smooth` the Catmull-Rom cubic of the quaternions,
/// normalized.
AxisAngle slerped(const Track<AxisAngle>& track, double time) {
  const auto [from, to, share] = find_stretch(track, time);
  const Easing& ease = track[from].ease;
  const auto at = [&](std::size_t i) { return quaternion_of(track[i].value); };
  if (ease.kind == Easing::Kind::smooth) {
    return axis_angle_of(interpolate<Eigen::Vector4d>(track, time, at).normalized());
  }
  return axis_angle_of(slerp(at(from), at(to), eased(ease, share)));
}

AxisAngle sample_rotation(const Track<AxisAngle>& track, double time) {
  const Stretch stretch = find_stretch(track, time);
  const AxisAngle& before = track[stretch.from].value;
  if (stretch.from == stretch.to || track[stretch.from].ease.kind == Easing::Kind::hold) return before;
  if (!same_axis(track)) return slerped(track, time);
  return {before.axis, interpolate<double>(track, time, [&](std::size_t i) { return track[i].value.angle; })};
}

void ride(const Follow& follow, const Vec3& pivot, double time, HandleMotion& motion) {
  const MeasuredCurve path(follow.path, Positions(0, 3));
  const double share =
      interpolate<double>(follow.shares, time, [&](std::size_t i) { return follow.shares[i].value; });
  motion.move = path.at(share) - pivot;
  if (follow.orient == Follow::Orient::tangent)
    motion.further.push_back(tangent_turn(path, follow.shares.front().value, share));
}

void turn_by_euler(const EulerTrack& euler, double time, HandleMotion& motion) {
  const Vec3 angles = sample_vector(euler.keys, time);
  const auto turn = [&](int axis) { return AxisAngle{Vec3::Unit(axis), angles[axis]}; };
  motion.rotation = turn(euler.order[0]);
  motion.further = {turn(euler.order[1]), turn(euler.order[2])};
}

void add_layer(const MotionTracks& layer, double time, HandleMotion& motion) {
  if (!layer.scale.empty()) motion.scale = motion.scale.cwiseProduct(sample_vector(layer.scale, time));
  if (!layer.rotate.empty()) motion.further.push_back(sample_rotation(layer.rotate, time));
  if (!layer.move.empty()) motion.move += sample_vector(layer.move, time);
}

void add_sway(const Sway& sway, double share, HandleMotion& motion) {
  const double amount = share * sway.amplitude.value;
  if (sway.kind == Sway::Kind::turn) {
    motion.further.push_back({sway.direction, amount});
  } else {
    motion.move += amount * sway.direction;
  }
}

}  // namespace

Eigen::Matrix3d HandleMotion::turn() const {
  Eigen::Matrix3d R = Eigen::AngleAxisd(rotation.angle, rotation.axis).toRotationMatrix();
  for (const AxisAngle& next : further) R = Eigen::AngleAxisd(next.angle, next.axis) * R;
  return R;
}

Vec3 HandleMotion::apply(const Vec3& x, const Vec3& pivot) const {
  const Vec3 arm = x - pivot;
  const Vec3 moved_arm = turn() * scale.cwiseProduct(arm);
  return x + (moved_arm - arm) + move;  // in this form a motion that does nothing gives x to the bit
}

double sample_lambda(const Track<double>& lambda, double time) {
  const auto at = [&](std::size_t i) { return lambda[i].value; };
  const auto slope = [&](std::size_t i) { return monotone_slope(lambda, i); };
  return std::clamp(interpolate<double>(lambda, time, at, slope), 0.0, 1.0);
}

bool is_active(const Handle& handle, double time) {
  const auto holds = [&](const Interval& interval) { return interval.from <= time && time < interval.to; };
  return handle.active.empty() || std::any_of(handle.active.begin(), handle.active.end(), holds);
}

bool active_together(const Handle& a, const Handle& b) {
  if (a.active.empty() || b.active.empty()) return true;
  return std::any_of(a.active.begin(), a.active.end(), [&](const Interval& one) {
    return std::any_of(b.active.begin(), b.active.end(), [&](const Interval& other) {
      return std::max(one.from, other.from) < std::min(one.to, other.to);
    });
  });
}

double sample_grip(const Handle& handle, double time) {
  if (!is_active(handle, time)) return 0;
  double share = 1;
  for (const auto& [from, to] : handle.active) {
    if (from > time || time >= to) continue;
    const double from_an_end = std::min(time - from, to - time);
    if (from_an_end < handle.fade) share = from_an_end / handle.fade;
  }
  return share * share * (3 - 2 * share);
}

HandleMotion sample_motion(const Handle& handle, const Vec3& pivot, double time) {
  HandleMotion motion;
  if (!handle.scale.empty()) motion.scale = sample_vector(handle.scale, time);
  if (!handle.rotate.empty()) motion.rotation = sample_rotation(handle.rotate, time);
  if (!handle.move.empty()) motion.move = sample_vector(handle.move, time);
  if (!handle.to.empty()) motion.move = sample_vector(handle.to, time) - pivot;
  if (!handle.euler.keys.empty()) turn_by_euler(handle.euler, time, motion);
  if (handle.follow) ride(*handle.follow, pivot, time, motion);
  for (const MotionTracks& layer : handle.layers) add_layer(layer, time, motion);
  for (const Wave& wave : handle.waves) add_sway(wave.sway, wave_at(wave, time), motion);
  for (const Noise& noise : handle.noises) add_sway(noise.sway, noise_at(noise, time), motion);
  return motion;
}

HandleMotion mirrored(const HandleMotion& motion, const Vec3& normal) {
  const auto reflected = [&](const Vec3& v) -> Vec3 { return v - 2 * normal.dot(v) * normal; };
  const auto turned =
      [&](const AxisAngle& turn) {  // an axis of rotation is no arrow: it points the other way
        return AxisAngle{-reflected(turn.axis), turn.angle};
      };
  HandleMotion other{motion.scale, turned(motion.rotation), {}, reflected(motion.move)};
  for (const AxisAngle& turn : motion.further) other.further.push_back(turned(turn));
  return other;
}

Positions sample_curve(const Track<Curve>& track, const Positions& chain, double time) {
  const Eigen::VectorXd shares = arc_shares(chain);
  const auto at = [&](std::size_t i) -> Positions {
    const Curve& curve = track[i].value;
    return curve.kind == Curve::Kind::rest ? chain : points_at(curve, chain, shares);
  };
  return interpolate<Positions>(track, time, at);
}

Positions points_at(const Curve& curve, const Positions& chain, const Eigen::VectorXd& shares) {
  const MeasuredCurve measured(curve, chain);
  Positions points(shares.size(), 3);
  for (Eigen::Index i = 0; i < shares.size(); ++i) points.row(i) = measured.at(shares[i]).transpose();
  return points;
}

}  // namespace flexkey
