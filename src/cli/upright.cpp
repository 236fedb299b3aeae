#include "cli/upright.h"

#include <Eigen/Geometry>

namespace flexkey::cli {
namespace {

/// (x, y, z) to (x, z, -y).
Eigen::Matrix4d standing_up() {
  Eigen::Matrix4d turn;
  turn << 1, 0, 0, 0,  //
      0, 0, 1, 0,      //
      0, -1, 0, 0,     //
      0, 0, 0, 1;
  return turn;
}

}  // namespace

Positions upright(const Positions& points) {
  Positions turned(points.rows(), 3);
  turned << points.col(0), points.col(2), -points.col(1);
  return turned;
}

void stand_upright(UpAxis up, Clip& clip, GltfOptions& options) {
  if (up == UpAxis::y) return;
  clip.mesh.positions = upright(clip.mesh.positions);
  for (Positions& frame : clip.frames) frame = upright(frame);
  const Eigen::Matrix4d turn = standing_up();
  for (PoseShape& pose : options.poses) pose.positions = upright(pose.positions);
  for (HandleTrack& handle : options.handles) {
    handle.pivot = turn.topLeftCorner<3, 3>() * handle.pivot;
    for (Eigen::Matrix4d& matrix : handle.matrices) matrix = turn * matrix * turn.transpose();
  }
}

}  // namespace flexkey::cli
