#include "flexkey/gltf/pose_targets.h"

#include <algorithm>
#include <set>
#include <string>

#include "flexkey/gltf/unique_name.h"

namespace flexkey {
namespace {

FloatRows deltas_between(const Positions& rest, const Positions& posed, double still) {
  FloatRows deltas = posed.cast<float>() - rest.cast<float>();
  for (Eigen::Index row = 0; row < deltas.rows(); ++row)
    if ((posed.row(row) - rest.row(row)).norm() <= still) deltas.row(row).setZero();
  return deltas;
}

}  // namespace

MorphTargets pose_targets(const Clip& clip, const std::vector<PoseShape>& poses, const NormalsAt& normals,
                          const StillBounds& still) {
  MorphTargets targets;
  if (poses.empty()) return targets;
  const Positions& rest = clip.mesh.positions;
  const Positions rest_normals = normals ? normals(rest) : Positions();
  for (const PoseShape& pose : poses) {
    targets.positions.push_back(deltas_between(rest, pose.positions, still.length));
    if (normals)
      targets.normals.push_back(deltas_between(rest_normals, normals(pose.positions), still.angle));
  }
  return targets;
}

void append_poses(Basis& basis, const std::vector<PoseShape>& poses) {
  std::set<std::string> known(basis.names.begin(), basis.names.end());
  for (const PoseShape& pose : poses) basis.names.push_back(unique_name(pose.name, known));
  const Eigen::Index own = basis.weights.cols(), all = own + std::ssize(poses);
  basis.weights.conservativeResize(Eigen::NoChange, all);
  basis.weights.rightCols(all - own).setZero();
}

double measure_poses(const Played& played, const Clip& clip, const std::vector<PoseShape>& poses,
                     const Basis& basis) {
  const double diagonal = bounds_of(clip.mesh.positions).diagonal();
  if (poses.empty() || diagonal <= 0) return 0;
  const Player player = played.positions.player();
  const Eigen::Index targets = basis.weights.cols();
  double largest = 0;
  for (std::size_t p = 0; p < poses.size(); ++p) {
    Eigen::RowVectorXf weights = Eigen::RowVectorXf::Zero(targets);
    weights[targets - std::ssize(poses) + static_cast<Eigen::Index>(p)] = 1;
    const Positions solved = poses[p].positions(played.positions.vertices, Eigen::all);
    largest = std::max(largest, (player(weights) - solved).rowwise().norm().maxCoeff());
  }
  return largest / diagonal;
}

}  // namespace flexkey
