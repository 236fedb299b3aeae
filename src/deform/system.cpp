#include "flexkey/deform/system.h"

#include <vector>

namespace flexkey {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// L_f: the columns of L that belong to F, on the patch's rows; rows x free.
Matrix free_columns(const Patch& patch) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < patch.rows; ++i) {
    double diagonal = 0;
    for (const auto [j, weight] : patch.cells.of(i)) {
      diagonal += weight;
      if (j < patch.free) entries.emplace_back(i, j, -weight);
    }
    if (i < patch.free) entries.emplace_back(i, i, diagonal);
  }
  Matrix columns(patch.rows, patch.free);
  columns.setFromTriplets(entries.begin(), entries.end());
  return columns;
}

Matrix system_matrix(const Patch& patch, System system) {
  const Matrix L_f = free_columns(patch);
  return system == System::direct ? L_f : Matrix(L_f.transpose() * L_f);
}

}  // namespace

Positions laplacian(const Cells& cells, int rows, const Positions& x) {
  Positions result = Positions::Zero(rows, 3);
  for (int i = 0; i < rows; ++i) {
    for (const auto [j, weight] : cells.of(i)) result.row(i) += weight * (x.row(i) - x.row(j));
  }
  return result;
}

LaplacianSystem::LaplacianSystem(const Patch& patch, System system)
    : system_(system), factor_(system_matrix(patch, system)) {}

Positions LaplacianSystem::step(const Patch& patch, const Positions& r, const Positions& p) const {
  // Solving for the step instead of p′ has the same minimiser, and what the last step lost to rounding the
  // next one makes good.
  const Positions residual = r - laplacian(patch.cells, patch.rows, p);
  if (system_ == System::direct) return factor_.solve(residual);
  // L is symmetric and every neighbour of F is a row, so L_fᵀ is L itself on the rows of F.
  return factor_.solve(laplacian(patch.cells, patch.free, residual));
}

}  // namespace flexkey
