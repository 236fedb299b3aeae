#include "flexkey/deform/rigid_system.h"

#include <algorithm>
#include <utility>

#include "flexkey/deform/rotation.h"
#include "flexkey/deform/surface_order.h"

namespace flexkey {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

constexpr int most_rounds = 20;    // over regions that lean on each other
constexpr double settled = 1e-15;  // change of a rotation's entries

Matrix matrix_of_arms(const std::vector<RigidRegion>& regions, int free) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const auto& [vertices, arms] = regions[r];
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      for (int c = 0; c < 3; ++c) {
        entries.emplace_back(vertices[k], static_cast<int>(3 * r) + c, arms(static_cast<Eigen::Index>(k), c));
      }
    }
  }
  Matrix A(free, static_cast<Eigen::Index>(3 * regions.size()));
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

Factor factored(const Matrix& N, const Matrix& C, const std::vector<int>& places) {
  if (C.cols() == 0) return factor_in_order(N, places);
  return factor_in_order(C.transpose() * N * C, places_of_unknowns(C, places));
}

}  // namespace

RigidSystem::RigidSystem(const Matrix& N, std::vector<RigidRegion> regions, const std::vector<int>& places)
    : regions_(std::move(regions)),
      C_(regions_.empty() ? Matrix() : summing_matrix(regions_, static_cast<int>(N.rows()))),
      factor_(factored(N, C_, places)) {
  if (regions_.empty()) return;
  A_ = matrix_of_arms(regions_, static_cast<int>(N.rows()));
  const Matrix NA = N * A_;
  const Eigen::MatrixXd coupling = Eigen::MatrixXd(C_.transpose() * NA);
  response_ = factor_.solve(coupling);
  stiffness_ = Eigen::MatrixXd(A_.transpose() * NA) - coupling.transpose() * response_;
}

std::size_t RigidSystem::bytes() const {
  const Eigen::Index numbers = response_.size() + stiffness_.size();
  const Eigen::Index entries = C_.nonZeros() + A_.nonZeros();
  return factor_.bytes() + static_cast<std::size_t>(numbers) * sizeof(double) +
         static_cast<std::size_t>(entries) * (sizeof(double) + sizeof(int));
}

Positions RigidSystem::step(const Positions& force, const Transforms& transforms) const {
  if (regions_.empty()) return factor_.solve(force);
  const Positions on_unknowns = C_.transpose() * force;
  const Eigen::MatrixXd F = A_.transpose() * force - response_.transpose() * on_unknowns;
  const Eigen::MatrixXd M = best_turns(F, transforms);
  const Positions u = factor_.solve(on_unknowns) - response_ * M;
  return C_ * u + A_ * M;
}

void RigidSystem::solve_in_place(std::span<Positions> forces, std::span<const Transforms* const> transforms,
                                 Factor::Workspace& workspace) const {
  if (regions_.empty()) {
    factor_.solve_in_place(forces, workspace);
    return;
  }
  for (std::size_t k = 0; k < forces.size(); ++k) forces[k] = step(forces[k], *transforms[k]);
}

/// M_kᵀ of all regions, one below the other: each the best while the others stay, in turn until none changes.
/// F: as in the class, transposed: 3 #regions x 3.
Eigen::MatrixXd RigidSystem::best_turns(const Eigen::MatrixXd& F, const Transforms& transforms) const {
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(F.rows(), 3);
  std::vector<Eigen::Matrix3d> rotations;
  for (const RigidRegion& region : regions_) rotations.push_back(rotation_of(region, transforms));
  for (int round = 0; round < most_rounds; ++round) {
    double change = 0;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      const auto first = static_cast<Eigen::Index>(3 * r);
      const Eigen::Matrix3d& start = rotation_of(regions_[r], transforms);
      const Eigen::Matrix3d own = stiffness_.block<3, 3>(first, first);
      const Eigen::Matrix3d of_others = stiffness_.middleRows<3>(first) * M - own * M.middleRows<3>(first);
      const Eigen::Matrix3d wanted = start * own + (F.middleRows<3>(first) - of_others).transpose();
      const Eigen::Matrix3d Q = best_rotation(wanted, rotations[r]);
      change = std::max(change, (Q - rotations[r]).cwiseAbs().maxCoeff());
      rotations[r] = Q;
      M.middleRows<3>(first) = (Q - start).transpose();
    }
    if (change <= settled || regions_.size() == 1) break;
  }
  return M;
}

}  // namespace flexkey
