#include "flexkey/deform/prediction.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#include "flexkey/deform/factor.h"

namespace flexkey {
namespace {

/// One right-hand side a handle: -L_fc 1_h, free x #handles; and L_ff.
struct HarmonicSystem {
  Eigen::SparseMatrix<double> L_ff;
  Eigen::MatrixXd b;
};

HarmonicSystem assemble(const Cells& clamped, const Patch& patch, const std::vector<int>& owner,
                        int handle_count) {
  std::vector<int> place(owner.size(), -1);  // in F
  for (int i = 0; i < patch.free; ++i) place[patch.vertices[i]] = i;
  std::vector<Eigen::Triplet<double>> entries;
  HarmonicSystem system{Eigen::SparseMatrix<double>(patch.free, patch.free),
                        Eigen::MatrixXd::Zero(patch.free, handle_count)};
  for (int i = 0; i < patch.free; ++i) {
    double diagonal = 0;
    for (const auto [j, weight] : clamped.of(patch.vertices[i])) {
      diagonal += weight;
      if (place[j] >= 0) {
        entries.emplace_back(i, place[j], -weight);
      } else if (owner[j] >= 0) {
        system.b(i, owner[j]) += weight;
      }
    }
    entries.emplace_back(i, i, diagonal);
  }
  system.L_ff.setFromTriplets(entries.begin(), entries.end());
  return system;
}

}  // namespace

Eigen::MatrixXd harmonic_weights(const Cells& clamped, const Patch& patch, const std::vector<int>& owner,
                                 int handle_count) {
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(patch.fitted, handle_count);
  for (int i = patch.free; i < patch.fitted; ++i) {
    const int handle = owner[patch.vertices[i]];
    if (handle >= 0) weights(i, handle) = 1;
  }
  const HarmonicSystem system = assemble(clamped, patch, owner, handle_count);
  weights.topRows(patch.free) = Factor(system.L_ff).solve(system.b);
  return weights;
}

Transforms turned(const Transforms& last, const Eigen::MatrixXd& weights, const Positions& turns) {
  Transforms result = last;
  const Positions vectors = weights * turns;
  for (std::size_t i = 0; i < result.rotations.size(); ++i) {
    const Vec3 turn = vectors.row(static_cast<Eigen::Index>(i)).transpose();
    const double angle = turn.norm();
    if (angle > 0) result.rotations[i] = Eigen::AngleAxisd(angle, turn / angle) * result.rotations[i];
  }
  return result;
}

Transforms continued(const Transforms& last, const std::vector<Eigen::Matrix3d>& earlier) {
  Transforms result = last;
  for (std::size_t i = 0; i < result.rotations.size(); ++i)
    result.rotations[i] = last.rotations[i] * earlier[i].transpose() * last.rotations[i];
  return result;
}

double misfit(const Transforms& predicted, const Transforms& found) {
  double sum = 0;
  for (std::size_t i = 0; i < found.rotations.size(); ++i)
    sum += (predicted.rotations[i] - found.rotations[i]).squaredNorm();
  return sum;
}

}  // namespace flexkey
