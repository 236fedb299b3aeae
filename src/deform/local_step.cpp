#include "flexkey/deform/local_step.h"

#include <tbb/parallel_for.h>

#include "flexkey/deform/rotation.h"

namespace flexkey {
namespace {

constexpr double collapsed = 1e-14;     // a cell shrunk to this share of its rest size is rounding noise
constexpr double undetermined = 1e-12;  // share of the cell's Σ ω |e|²

/// The sums over a cell's edges that R_i and S_i are fitted from.
struct CellMoments {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();  // Σ ω e′ eᵀ
  Eigen::Matrix3d C = Eigen::Matrix3d::Zero();  // Σ ω e eᵀ
  double size = 0;                              // Σ |ω| |e|²
};

CellMoments moments(const Patch& patch, const Positions& positions, int i) {
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

}  // namespace

Vec3 best_scale(const Eigen::Matrix3d& A, const Eigen::Matrix3d& C, const Eigen::Matrix3d& R,
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

Transforms local_step(const Patch& patch, const Positions& positions, const Transforms& previous,
                      const DeformOptions& options) {
  Transforms fit{std::vector<Eigen::Matrix3d>(patch.fitted), Positions(patch.fitted, 3)};
  // Every cell is fitted on its own, so that the answer does not depend on the number of threads.
  tbb::parallel_for(0, patch.fitted, [&](int i) {
    const CellMoments sums = moments(patch, positions, i);
    const bool has_shape = sums.A.norm() > collapsed * sums.size;
    fit.rotations[i] = has_shape ? best_rotation(sums.A, previous.rotations[i]) : previous.rotations[i];
    fit.scales.row(i) = best_scale(sums.A, sums.C, fit.rotations[i], options);
  });
  return fit;
}

}  // namespace flexkey
