#include "flexkey/animate/handle_states.h"

#include <Eigen/Geometry>

#include "flexkey/animate/turn_vector.h"
#include "flexkey/deform/rotation.h"

namespace flexkey {
namespace {

/// The rigid motion that best takes the chain to the curve; of several, the one that turns least.
Eigen::Affine3d best_fit(const Positions& rest, const Positions& posed) {
  if (rest == posed) return Eigen::Affine3d::Identity();  // to the last bit
  const Vec3 from = rest.colwise().mean(), to = posed.colwise().mean();
  const Positions a = rest.rowwise() - from.transpose(), b = posed.rowwise() - to.transpose();
  return Eigen::Translation3d(to) * best_rotation(b.transpose() * a, Eigen::Matrix3d::Identity()) *
         Eigen::Translation3d(-from);
}

bool lies_on_curve(const SceneHandle& bound) {
  return !bound.handle.curve.empty();
}

/// The handle's own turns, and after them those of its parents.
std::vector<AxisAngle> turns_of(const Scene& scene, const HandleStates& states, int handle) {
  std::vector<AxisAngle> turns;
  for (int h = handle; h >= 0; h = scene.handles[static_cast<std::size_t>(h)].handle.parent) {
    const SceneHandle& bound = scene.handles[static_cast<std::size_t>(h)];
    if (lies_on_curve(bound)) {
      const Eigen::AngleAxisd turn(
          best_fit(bound.rest, states.curves[static_cast<std::size_t>(h)]).rotation());
      turns.push_back({turn.axis(), turn.angle()});
      break;
    }
    const HandleMotion& motion = states.motions[static_cast<std::size_t>(h)];
    turns.push_back(motion.rotation);
    turns.insert(turns.end(), motion.further.begin(), motion.further.end());
  }
  return turns;
}

/// The rotation vector that best maps one chain to the next; of several, the smallest turn.
Vec3 fitted_turn(const Positions& from, const Positions& to) {
  const Positions a = from.rowwise() - from.colwise().mean(), b = to.rowwise() - to.colwise().mean();
  const Eigen::AngleAxisd turn(best_rotation(b.transpose() * a, Eigen::Matrix3d::Identity()));
  return turn.angle() * turn.axis();
}

/// x -> pivot + R S (x - pivot) + move
Eigen::Affine3d affine(const HandleMotion& motion, const Vec3& pivot) {
  return Eigen::Translation3d(pivot + motion.move) * Eigen::Affine3d(motion.turn()) *
         Eigen::Scaling(motion.scale) * Eigen::Translation3d(-pivot);
}

/// Points at rest where the handle's motion, and then those of its parents, take them.
Positions moved(const Scene& scene, const HandleStates& states, int handle, Positions points) {
  for (int h = handle; h >= 0; h = scene.handles[static_cast<std::size_t>(h)].handle.parent) {
    const SceneHandle& bound = scene.handles[static_cast<std::size_t>(h)];
    if (lies_on_curve(bound)) {  // which has followed its parents
      const Eigen::Affine3d motion = best_fit(bound.rest, states.curves[static_cast<std::size_t>(h)]);
      return (points * motion.linear().transpose()).rowwise() + motion.translation().transpose();
    }
    const HandleMotion& motion = states.motions[static_cast<std::size_t>(h)];
    for (auto point : points.rowwise()) point = motion.apply(point.transpose(), bound.pivot).transpose();
  }
  return points;
}

/// Of a handle that is led by no curve.
HandleMotion own_motion(const Scene& scene, std::size_t handle, double time) {
  const SceneHandle& bound = scene.handles[handle];
  if (!bound.handle.mirror) return sample_motion(bound.handle, bound.pivot, time);
  const Mirror& mirror = *bound.handle.mirror;
  HandleMotion motion =
      mirrored(own_motion(scene, static_cast<std::size_t>(mirror.of), time - mirror.delay), mirror.normal);
  // What sways the handle itself comes after.
  const HandleMotion sway = sample_motion(bound.handle, bound.pivot, time);
  motion.further.insert(motion.further.end(), sway.further.begin(), sway.further.end());
  motion.move += sway.move;
  return motion;
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
  for (std::size_t h = 0; h < scene.handles.size(); ++h)
    if (!lies_on_curve(scene.handles[h])) states.motions[h] = own_motion(scene, h, time);
  for (std::size_t h = 0; h < scene.handles.size(); ++h) {
    const SceneHandle& bound = scene.handles[h];
    if (lies_on_curve(bound))
      states.curves[h] =
          moved(scene, states, bound.handle.parent, sample_curve(bound.handle.curve, bound.rest, time));
  }
  return states;
}

HandleStates blend(const HandleStates& from, const HandleStates& to, double share) {
  HandleStates between = from;
  for (std::size_t h = 0; h < from.motions.size(); ++h) {
    const HandleMotion &a = from.motions[h], &b = to.motions[h];
    between.motions[h] = {a.scale + share * (b.scale - a.scale),
                          blend(a.rotation, b.rotation, share),
                          {},
                          a.move + share * (b.move - a.move)};
    for (std::size_t k = 0; k < b.further.size(); ++k) {
      const AxisAngle before = k < a.further.size() ? a.further[k] : AxisAngle{b.further[k].axis, 0};
      between.motions[h].further.push_back(blend(before, b.further[k], share));
    }
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
  return moved(scene, states, handle, scene.handles[h].rest);
}

Eigen::Affine3d whole_motion(const Scene& scene, const HandleStates& states, int handle) {
  Eigen::Affine3d whole = Eigen::Affine3d::Identity();
  for (int h = handle; h >= 0; h = scene.handles[static_cast<std::size_t>(h)].handle.parent) {
    const SceneHandle& bound = scene.handles[static_cast<std::size_t>(h)];
    const auto k = static_cast<std::size_t>(h);
    if (lies_on_curve(bound)) return best_fit(bound.rest, states.curves[k]) * whole;
    whole = affine(states.motions[k], bound.pivot) * whole;
  }
  return whole;
}

Positions turns_between(const Scene& scene, const HandleStates& from, const HandleStates& to) {
  const std::size_t count = from.motions.size();
  Positions turns(static_cast<Eigen::Index>(count), 3);
  for (std::size_t h = 0; h < count; ++h) {
    const bool has_vertices = from.curves[h].rows() > 0 && to.curves[h].rows() > 0;
    const auto handle = static_cast<int>(h);
    const Vec3 turn = has_vertices ? fitted_turn(from.curves[h], to.curves[h])
                                   : turn_vector(turns_of(scene, from, handle), turns_of(scene, to, handle));
    turns.row(handle) = turn.transpose();
  }
  return turns;
}

}  // namespace flexkey
