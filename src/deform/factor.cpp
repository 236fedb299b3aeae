#include "flexkey/deform/factor.h"

#include "flexkey/deform/cholesky.h"
#include "flexkey/deform/error.h"
#include "flexkey/deform/substitution.h"

namespace flexkey {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

constexpr double least_pivot = 1e-15;  // share of the diagonal entry; less is rounding noise

bool is_sound(const Cholesky& factored, const Matrix& matrix) {
  const Eigen::VectorXd roots = factored.order.inverse() * diagonal(factored.L);
  for (int k = 0; k < roots.size(); ++k) {
    if (!(roots[k] * roots[k] > least_pivot * matrix.coeff(k, k))) return false;
  }
  return true;
}

double* room_for(int rows, int width, Factor::Workspace& workspace) {
  constexpr std::size_t line = sizeof(Factor::Workspace::Line) / sizeof(double);
  const std::size_t lines =
      (static_cast<std::size_t>(rows) * static_cast<std::size_t>(width) + line - 1) / line;
  if (workspace.lines.size() < lines) workspace.lines.resize(lines);
  return workspace.lines.data()->numbers;
}

}  // namespace

struct Factor::Backend {
  Substitution substitution;
};

Factor::Factor(const Matrix& matrix) : Factor(matrix, fill_reducing_order(matrix)) {}

Factor::Factor(const Matrix& matrix, const Permutation& order) : backend_(std::make_unique<Backend>()) {
  if (matrix.cols() == 0) return;
  std::optional<Cholesky> factored = cholesky(matrix, order);
  if (!factored || !is_sound(*factored, matrix)) {
    throw DeformError(
        "the surface's equations are singular to working precision; hold more vertices, or use "
        "weights 'clamped' or 'uniform'");
  }
  auto& [rows, L, shares, sweeps] = backend_->substitution;
  const Permutation inverse = factored->order.inverse();
  rows.assign(inverse.indices().begin(), inverse.indices().end());
  L = std::move(factored->L);
  shares = partition(L);
  sweeps = sweeps_for_this_processor().sweeps[0];
}

Factor::~Factor() = default;
Factor::Factor(Factor&&) noexcept = default;
Factor& Factor::operator=(Factor&&) noexcept = default;

Positions Factor::solve(const Positions& b) const {
  Positions x = b;
  Workspace workspace;
  solve_in_place({&x, 1}, workspace);
  return x;
}

Eigen::MatrixXd Factor::solve(const Eigen::MatrixXd& b) const {
  Eigen::MatrixXd x = b;
  Workspace workspace;
  for (Eigen::Index first = 0; first < x.cols() && x.rows() > 0; first += RightHandSides::most) {
    RightHandSides columns;
    columns.count = static_cast<int>(std::min<Eigen::Index>(RightHandSides::most, x.cols() - first));
    for (int c = 0; c < columns.count; ++c) columns.columns[c] = x.col(first + c).data();
    const Substitution& factor = backend_->substitution;
    substitute(factor, columns, room_for(factor.partition.rows, columns.width(), workspace));
  }
  return x;
}

void Factor::solve_in_place(std::span<Positions> b, Workspace& workspace) const {
  const Substitution& factor = backend_->substitution;
  constexpr std::size_t most = RightHandSides::most / 3;
  for (; !b.empty() && !factor.rows.empty(); b = b.subspan(std::min(most, b.size()))) {
    RightHandSides columns;
    columns.stride = 3;
    for (Positions& positions : b.first(std::min(most, b.size()))) {
      for (int c = 0; c < 3; ++c) columns.columns[columns.count++] = positions.data() + c;
    }
    substitute(factor, columns, room_for(factor.partition.rows, columns.width(), workspace));
  }
}

std::size_t Factor::bytes() const {
  const auto& [rows, L, shares, sweeps] = backend_->substitution;
  std::size_t sum = rows.capacity() * sizeof(int) + flexkey::bytes(L);
  for (const Piece& piece : shares.pieces) {
    sum += sizeof(Piece) + 2 * piece.border.capacity() * sizeof(int);
  }
  return sum;
}

}  // namespace flexkey
