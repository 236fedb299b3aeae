#include "flexkey/deform/system.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "flexkey/deform/residual.h"

namespace flexkey {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// L_f: the columns of L that belong to F, on the patch's rows; rows x free. L is symmetric and every
/// neighbour of F is a row or, in a direct system, fixed: a cell of F is a column.
Matrix free_columns(const Patch& patch) {
  Eigen::VectorXi room(patch.free);
  for (int j = 0; j < patch.free; ++j) room(j) = static_cast<int>(patch.cells.of(j).size()) + 1;
  Matrix columns(patch.rows, patch.free);
  columns.reserve(room);
  for (int j = 0; j < patch.free; ++j) {
    double diagonal = 0;
    for (const auto [i, weight] : patch.cells.of(j)) {
      diagonal += weight;
      if (i < patch.rows) columns.insert(i, j) = -weight;
    }
    columns.insert(j, j) = diagonal;
  }
  if (patch.free > 0) columns.makeCompressed();  // which reads past the arrays of none
  return columns;
}

Matrix system_matrix(const Patch& patch, System system, const Eigen::VectorXd& row_weights) {
  const Matrix L_f = free_columns(patch);
  if (system == System::direct) return L_f;
  if (row_weights.size() == 0) return L_f.transpose() * L_f;
  return L_f.transpose() * row_weights.head(patch.rows).asDiagonal() * L_f;
}

}  // namespace

LaplacianSystem::LaplacianSystem(const Patch& patch, System system, const Ties& ties,
                                 const Eigen::VectorXd& row_weights)
    : LaplacianSystem(system, system_matrix(patch, system, row_weights), ties) {
  row_weights_ = row_weights.head(std::min<Eigen::Index>(row_weights.size(), patch.rows));
}

LaplacianSystem::LaplacianSystem(System system, const Matrix& N, const Ties& ties)
    : system_(system),
      springs_(make_springs(N, ties.soft)),
      tied_(with_springs(N, springs_), ties.rigid, ties.places) {}

const Factor* LaplacianSystem::plain_factor() const {
  return springs_.vertices.empty() ? tied_.plain_factor() : nullptr;
}

// Solving for the step instead of p′ has the same minimiser, and what the last step lost to rounding the next
// one makes good.
void LaplacianSystem::reduce(const CellTables& cells, Positions& rows, Positions& force) const {
  if (system_ == System::direct) {
    force.swap(rows);
    return;
  }
  if (row_weights_.size() > 0) rows.array().colwise() *= row_weights_.array();
  // L is symmetric and every neighbour of F is a row, so L_fᵀ is L itself on the rows of F.
  free_laplacian(cells, rows, force);
}

void LaplacianSystem::solve_in_place(std::span<Positions> forces,
                                     std::span<const Transforms* const> transforms,
                                     Factor::Workspace& workspace) const {
  tied_.solve_in_place(forces, transforms, workspace);
}

}  // namespace flexkey
