#include "flexkey/animate/handle_states.h"

#include <Eigen/Geometry>

#include "flexkey/deform/rotation.h"

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

AxisAngle blend(const AxisAngle& from, const AxisAngle& to, double share) {
  if (const Vec3* axis = common_axis(from, to)) return {*axis, from.angle + share * (to.angle - from.angle)};
  return axis_angle(quaternion(from).slerp(share, quaternion(to)));
}

Vec3 turn_vector(const AxisAngle& from, const AxisAngle& to) {
  if (const Vec3* axis = common_axis(from, to)) return (to.angle - from.angle) * *axis;
  const AxisAngle turn = axis_angle(quaternion(to) * quaternion(from).conjugate());
  return turn.angle * turn.axis;
}

/// The rotation vector that best maps one chain to the next; of several, the smallest turn.
Vec3 turn_vector(const Positions& from, const Positions& to) {
  const Positions a = from.rowwise() - from.colwise().mean(), b = to.rowwise() - to.colwise().mean();
  const Eigen::AngleAxisd turn(best_rotation(b.transpose() * a, Eigen::Matrix3d::Identity()));
  return turn.angle() * turn.axis();
}

}  // namespace

HandleStates rest_states(const Scene& scene) {
  HandleStates states;
  states.motions.resize(scene.handles.size());
  for (const SceneHandle& bound : scene.handles)
    states.curves.push_back(bound.handle.curve.empty() ? Positions(0, 3) : bound.rest);
  return states;
}

HandleStates sample_states(const Scene& scene, double time) {
  HandleStates states = rest_states(scene);
  for (std::size_t h = 0; h < scene.handles.size(); ++h) {
    const SceneHandle& bound = scene.handles[h];
    if (bound.handle.curve.empty()) {
      states.motions[h] = sample_motion(bound.handle, bound.pivot, time);
    } else {
      states.curves[h] = sample_curve(bound.handle.curve, bound.rest, time);
    }
  }
  return states;
}

HandleStates blend(const HandleStates& from, const HandleStates& to, double share) {
  HandleStates between = from;
  for (std::size_t h = 0; h < from.motions.size(); ++h) {
    const HandleMotion &a = from.motions[h], &b = to.motions[h];
    between.motions[h] = {a.scale + share * (b.scale - a.scale), blend(a.rotation, b.rotation, share),
                          a.move + share * (b.move - a.move)};
    if (from.curves[h].rows() == to.curves[h].rows())
      between.curves[h] = from.curves[h] + share * (to.curves[h] - from.curves[h]);
  }
  return between;
}

Positions targets_of(const Scene& scene, const HandleStates& states) {
  Positions targets(static_cast<Eigen::Index>(scene.constraints.handles.size()), 3);
  Eigen::Index row = 0;
  for (std::size_t h = 0; h < scene.handles.size(); ++h) {
    const Positions where = targets_of(scene, states, static_cast<int>(h));
    targets.middleRows(row, where.rows()) = where;
    row += where.rows();
  }
  return targets;
}

Positions targets_of(const Scene& scene, const HandleStates& states, int handle) {
  const auto h = static_cast<std::size_t>(handle);
  if (states.curves[h].rows() > 0) return states.curves[h];
  const SceneHandle& bound = scene.handles[h];
  Positions targets(bound.rest.rows(), 3);
  for (Eigen::Index k = 0; k < targets.rows(); ++k)
    targets.row(k) = states.motions[h].apply(bound.rest.row(k).transpose(), bound.pivot).transpose();
  return targets;
}

Positions turns_between(const HandleStates& from, const HandleStates& to) {
  const std::size_t count = from.motions.size();
  Positions turns(static_cast<Eigen::Index>(count), 3);
  for (std::size_t h = 0; h < count; ++h) {
    const bool is_curve = from.curves[h].rows() > 0 && to.curves[h].rows() > 0;
    const Vec3 turn = is_curve ? turn_vector(from.curves[h], to.curves[h])
                               : turn_vector(from.motions[h].rotation, to.motions[h].rotation);
    turns.row(static_cast<Eigen::Index>(h)) = turn.transpose();
  }
  return turns;
}

}  // namespace flexkey
