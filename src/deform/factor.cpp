#include "flexkey/deform/factor.h"

#include <Eigen/SparseCholesky>

#include "flexkey/deform/error.h"
#include "flexkey/deform/ordering.h"

namespace flexkey {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Cholesky = Eigen::SimplicialLLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>>;

constexpr double least_pivot = 1e-15;  // share of the diagonal entry; less is rounding noise

/// L of L Lᵀ = matrix; its columns begin with the diagonal.
Matrix lower_factor(const Matrix& matrix) {
  const Cholesky cholesky(matrix);
  if (cholesky.info() != Eigen::Success) return {};
  return cholesky.matrixL().nestedExpression();
}

bool is_sound(const Matrix& lower, const Matrix& matrix) {
  if (lower.cols() != matrix.cols()) return false;
  for (int k = 0; k < lower.cols(); ++k) {
    const double root = lower.valuePtr()[lower.outerIndexPtr()[k]];
    if (!(root * root > least_pivot * matrix.coeff(k, k))) return false;
  }
  return true;
}

}  // namespace

struct Factor::Backend {
  Permutation order;
  Matrix lower;
};

Factor::Factor(const Matrix& matrix) : backend_(std::make_unique<Backend>()) {
  if (matrix.cols() == 0) return;
  backend_->order = fill_reducing_order(matrix);
  Matrix ordered;
  ordered = matrix.twistedBy(backend_->order);
  backend_->lower = lower_factor(ordered);
  if (!is_sound(backend_->lower, ordered)) {
    throw DeformError(
        "the surface's equations are singular to working precision; hold more vertices, or use "
        "weights 'clamped' or 'uniform'");
  }
}

Factor::~Factor() = default;
Factor::Factor(Factor&&) noexcept = default;
Factor& Factor::operator=(Factor&&) noexcept = default;

Positions Factor::solve(const Positions& b) const {
  if (b.rows() == 0) return b;
  // The factor is read once for x, y and z together: reading it is what a large solve costs.
  Positions x = backend_->order * b;
  const int* first = backend_->lower.outerIndexPtr();
  const int* row = backend_->lower.innerIndexPtr();
  const double* value = backend_->lower.valuePtr();
  const int n = static_cast<int>(x.rows());
  for (int k = 0; k < n; ++k) {
    const Eigen::RowVector3d x_k = x.row(k) /= value[first[k]];
    for (int at = first[k] + 1; at < first[k + 1]; ++at) x.row(row[at]) -= value[at] * x_k;
  }
  for (int k = n - 1; k >= 0; --k) {
    Eigen::RowVector3d x_k = x.row(k);
    for (int at = first[k] + 1; at < first[k + 1]; ++at) x_k -= value[at] * x.row(row[at]);
    x.row(k) = x_k / value[first[k]];
  }
  return backend_->order.inverse() * x;
}

}  // namespace flexkey
