#include "flexkey/animate/turn_vector.h"

#include <Eigen/Geometry>
#include <numbers>

namespace flexkey {
namespace {

Eigen::Quaterniond quaternion(const AxisAngle& turn) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(turn.angle, turn.axis));
}

AxisAngle axis_angle(const Eigen::Quaterniond& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return {turn.axis(), turn.angle()};
}

/// The axis that two turns have in common, a turn by no angle having every axis; or none.
const Vec3* common_axis(const AxisAngle& a, const AxisAngle& b) {
  if (a.angle == 0) return &b.axis;
  if (b.angle == 0 || a.axis == b.axis) return &a.axis;
  return nullptr;
}

Vec3 turn_vector(const AxisAngle& from, const AxisAngle& to) {
  if (const Vec3* axis = common_axis(from, to)) return (to.angle - from.angle) * *axis;
  const AxisAngle turn = axis_angle(quaternion(to) * quaternion(from).conjugate());
  return turn.angle * turn.axis;
}

}  // namespace

AxisAngle blend(const AxisAngle& from, const AxisAngle& to, double share) {
  if (const Vec3* axis = common_axis(from, to)) return {*axis, from.angle + share * (to.angle - from.angle)};
  return axis_angle(quaternion(from).slerp(share, quaternion(to)));
}

Vec3 turn_vector(const std::vector<AxisAngle>& from, const std::vector<AxisAngle>& to) {
  Vec3 sum = Vec3::Zero();
  Eigen::Quaterniond change = Eigen::Quaterniond::Identity();
  int changed = 0;
  for (std::size_t k = 0; k < to.size(); ++k) {
    const AxisAngle before = k < from.size() ? from[k] : AxisAngle{to[k].axis, 0};
    const Eigen::Quaterniond outer = quaternion(before);  // what turned until now is turned by this one too
    const Vec3 own = turn_vector(before, to[k]);
    sum = own + outer * sum;
    change = quaternion(to[k]) * change * outer.conjugate();
    changed += own.isZero(0) ? 0 : 1;
  }
  if (changed < 2 || sum.norm() > std::numbers::pi) return sum;
  const AxisAngle turn = axis_angle(change);
  return turn.angle * turn.axis;
}

}  // namespace flexkey
