#include "flexkey/animate/file_positions.h"

#include <Eigen/Geometry>

namespace flexkey {
namespace {

/// The rigid motion that best takes a patch from rest to where it is (Kabsch).
Eigen::Isometry3d rigid_motion(const Positions& rest, const Positions& posed) {
  if (rest == posed) return Eigen::Isometry3d::Identity();  // to the last bit, so that rest stays rest
  return Eigen::Isometry3d(Eigen::umeyama(rest.transpose(), posed.transpose(), false));
}

}  // namespace

Positions file_positions(const Scene& scene, const Pose& pose) {
  const Positions& rest = scene.weld.surface.positions;
  Positions positions = pose.positions;
  for (const Rider& rider : scene.riders) {
    const Eigen::Isometry3d motion =
        rigid_motion(rest(rider.carriers, Eigen::all), pose.positions(rider.carriers, Eigen::all));
    for (const int v : rider.vertices)
      positions.row(v) = (motion * Vec3(rest.row(v).transpose())).transpose();
  }
  return scatter(scene.weld, positions);
}

}  // namespace flexkey
