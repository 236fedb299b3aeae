#include "flexkey/animate/handle_matrices.h"

#include <Eigen/Geometry>

#include "flexkey/animate/handle_states.h"
#include "flexkey/deform/rotation.h"

namespace flexkey {
namespace {

/// x -> pivot + R S (x - pivot) + move
Eigen::Affine3d affine(const HandleMotion& motion, const Vec3& pivot) {
  return Eigen::Translation3d(pivot + motion.move) *
         Eigen::AngleAxisd(motion.rotation.angle, motion.rotation.axis) * Eigen::Scaling(motion.scale) *
         Eigen::Translation3d(-pivot);
}

/// The rigid motion that best takes the chain to the curve; of several, the one that turns least.
Eigen::Affine3d best_fit(const Positions& rest, const Positions& posed) {
  if (rest == posed) return Eigen::Affine3d::Identity();  // to the last bit
  const Vec3 from = rest.colwise().mean(), to = posed.colwise().mean();
  const Positions a = rest.rowwise() - from.transpose(), b = posed.rowwise() - to.transpose();
  return Eigen::Translation3d(to) * best_rotation(b.transpose() * a, Eigen::Matrix3d::Identity()) *
         Eigen::Translation3d(-from);
}

}  // namespace

std::vector<Eigen::Matrix4d> handle_matrices(const Scene& scene, double time) {
  const HandleStates states = sample_states(scene, time);
  std::vector<Eigen::Matrix4d> matrices;
  for (std::size_t h = 0; h < scene.handles.size(); ++h) {
    const SceneHandle& bound = scene.handles[h];
    const Eigen::Affine3d motion = bound.handle.curve.empty() ? affine(states.motions[h], bound.pivot)
                                                              : best_fit(bound.rest, states.curves[h]);
    matrices.push_back(motion.matrix());
  }
  return matrices;
}

}  // namespace flexkey
