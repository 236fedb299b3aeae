#pragma once

#include <cmath>

#include "flexkey/deform/local_step.h"
#include "flexkey/deform/patch.h"
#include "flexkey/deform/rotation.h"

/// The steps of an iteration as the paper writes them, a cell after the other: what the frame loop's kernels
/// are held against.
namespace flexkey::plain {

inline constexpr double collapsed = 1e-14;  // a cell shrunk to this share of its rest size is rounding noise
inline constexpr double undetermined = 1e-12;  // share of the cell's Σ ω |e|²

/// The sums over a cell's edges that R_i and S_i are fitted from.
struct CellMoments {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();  // Σ ω e′ eᵀ
  Eigen::Matrix3d C = Eigen::Matrix3d::Zero();  // Σ ω e eᵀ
  double size = 0;                              // Σ |ω| |e|²
};

inline CellMoments moments(const Patch& patch, const Positions& positions, int i) {
  CellMoments sums;
  for (const auto [j, weight] : patch.cells.of(i)) {
    const Vec3 e = patch.rest.row(i) - patch.rest.row(j);
    const Vec3 e_deformed = positions.row(i) - positions.row(j);
    sums.A += (weight * e_deformed) * e.transpose();
    sums.C += (weight * e) * e.transpose();
    sums.size += std::abs(weight) * e.squaredNorm();
  }
  return sums;
}

inline Vec3 best_scale(const Eigen::Matrix3d& A, const Eigen::Matrix3d& C, const Eigen::Matrix3d& R,
                       const DeformOptions& options) {
  const double size = C.trace();  // Σ ω |R e|²
  if (options.local_scale == LocalScale::none || !(size > 0)) return Vec3::Ones();
  const Eigen::Matrix3d deformed = A * R.transpose();  // Σ ω e′ (R e)ᵀ
  if (options.local_scale == LocalScale::uniform) return Vec3::Constant(deformed.trace() / size);
  const Eigen::Matrix3d rotated = R * C * R.transpose();  // Σ ω (R e) (R e)ᵀ
  Vec3 s;
  for (int k = 0; k < 3; ++k) {
    const double denominator = rotated(k, k) + options.epsilon * size;
    const double numerator = deformed(k, k) + options.epsilon * deformed.trace();
    s(k) = denominator < undetermined * size ? 1 : numerator / denominator;
  }
  return s;
}

inline Transforms local_step(const Patch& patch, const Positions& positions, const Transforms& previous,
                             const DeformOptions& options) {
  Transforms fit{std::vector<Eigen::Matrix3d>(patch.fitted), Positions(patch.fitted, 3)};
  for (int i = 0; i < patch.fitted; ++i) {
    const CellMoments sums = moments(patch, positions, i);
    const bool has_shape = sums.A.norm() > collapsed * sums.size;
    fit.rotations[i] = has_shape ? best_rotation(sums.A, previous.rotations[i]) : previous.rotations[i];
    fit.scales.row(i) = best_scale(sums.A, sums.C, fit.rotations[i], options);
  }
  return fit;
}

inline Positions right_hand_side(const Patch& patch, const Transforms& transforms,
                                 const Eigen::VectorXd& lambda) {
  const std::vector<Eigen::Matrix3d>& R = transforms.rotations;
  Positions r(patch.rows, 3);
  for (int i = 0; i < patch.rows; ++i) {
    const auto S_i = transforms.scales.row(i).transpose().asDiagonal();
    Vec3 delta = Vec3::Zero();
    Vec3 rigid = Vec3::Zero();
    for (const auto [j, weight] : patch.cells.of(i)) {
      const Vec3 e = patch.rest.row(i) - patch.rest.row(j);
      delta += weight * e;
      rigid += weight / 2 * ((R[i] + R[j]) * e);
    }
    const Vec3 smooth = S_i * (R[i] * delta);
    r.row(i) = lambda(i) * rigid + (1 - lambda(i)) * smooth;
  }
  return r;
}

inline Positions laplacian(const Cells& cells, int rows, const Positions& x) {
  Positions result = Positions::Zero(rows, 3);
  for (int i = 0; i < rows; ++i) {
    for (const auto [j, weight] : cells.of(i)) result.row(i) += weight * (x.row(i) - x.row(j));
  }
  return result;
}

}  // namespace flexkey::plain
