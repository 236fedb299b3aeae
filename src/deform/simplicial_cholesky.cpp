#include <Eigen/SparseCholesky>
#include <algorithm>

#include "flexkey/deform/cholesky.h"
#include "flexkey/deform/elimination_tree.h"

namespace flexkey {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using SimplicialCholesky = Eigen::SimplicialLLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int>>;

Permutation in_postorder(const Matrix& matrix, const Permutation& order) {
  const std::vector<int> places = postorder(elimination_tree(matrix, order));
  Permutation composed(order.size());
  for (int i = 0; i < order.size(); ++i) composed.indices()[i] = places[order.indices()[i]];
  return composed;
}

int entries_of(const Matrix& lower, int column) {
  return lower.outerIndexPtr()[column + 1] - lower.outerIndexPtr()[column];
}

/// The column's parent in the elimination tree, or #columns. lower: each column begins with its diagonal.
int parent_of(const Matrix& lower, int column) {
  if (entries_of(lower, column) == 1) return static_cast<int>(lower.cols());
  return lower.innerIndexPtr()[lower.outerIndexPtr()[column] + 1];
}

/// The first column of each run of columns with the same rows below it, and the end of the last.
std::vector<int> exact_supernodes(const Matrix& lower) {
  std::vector<int> columns{0};
  for (int k = 1; k < lower.cols(); ++k) {
    const bool same_rows =
        parent_of(lower, k - 1) == k && entries_of(lower, k) == entries_of(lower, k - 1) - 1;
    if (!same_rows) columns.push_back(k);
  }
  columns.push_back(static_cast<int>(lower.cols()));
  return columns;
}

/// Whether one supernode more would cost more than to store zeros for the columns from `first` to `end`.
bool pays(const Matrix& lower, int first, int end) {
  const double width = end - first;
  const double below = entries_of(lower, end - 1) - 1;
  const double stored = width * (width + 1) / 2 + width * below;
  const double zeros = stored - (lower.outerIndexPtr()[end] - lower.outerIndexPtr()[first]);
  return zeros <= (width <= 4 ? 0.8 : width <= 16 ? 0.3 : width <= 48 ? 0.1 : 0.05) * stored;
}

/// Joins supernodes to a parent that follows them where it pays.
std::vector<int> relaxed_supernodes(const Matrix& lower) {
  const std::vector<int> exact = exact_supernodes(lower);
  std::vector<int> columns{exact.back()};  // from the end to the beginning
  int end = exact.back();                  // of the supernode that begins with columns.back()
  for (std::size_t s = exact.size() - 1; s-- > 0;) {
    if (parent_of(lower, exact[s + 1] - 1) < end && pays(lower, exact[s], end)) {
      columns.back() = exact[s];
    } else {
      end = columns.back();
      columns.push_back(exact[s]);
    }
  }
  std::reverse(columns.begin(), columns.end());
  return columns;
}

/// The rows below a supernode are those below its last column.
Supernodes pattern_of(const Matrix& lower) {
  Supernodes L;
  L.columns = relaxed_supernodes(lower);
  for (int s = 0; s < L.count(); ++s) {
    const int last = L.columns[s + 1] - 1;
    const int* rows = lower.innerIndexPtr() + lower.outerIndexPtr()[last];
    L.rows.insert(L.rows.end(), rows + 1, rows + entries_of(lower, last));
    L.row_offsets.push_back(static_cast<std::int64_t>(L.rows.size()));
  }
  return L;
}

Supernodes supernodes_of(const Matrix& lower) {
  Supernodes L = pattern_of(lower);
  allocate_values(L);
  std::vector<int> places(lower.rows());  // of the rows of one supernode in its trapezoid
  std::vector<double> block;
  for (int s = 0; s < L.count(); ++s) {
    const int height = L.width(s) + L.below(s);
    for (int i = 0; i < L.width(s); ++i) places[L.columns[s] + i] = i;
    for (int i = 0; i < L.below(s); ++i) places[L.rows[L.row_offsets[s] + i]] = L.width(s) + i;
    block.assign(static_cast<std::size_t>(height) * L.width(s), 0);
    for (int c = 0; c < L.width(s); ++c) {
      double* column = block.data() + static_cast<std::ptrdiff_t>(c) * height;
      for (Matrix::InnerIterator entry(lower, L.columns[s] + c); entry; ++entry) {
        column[places[entry.row()]] = entry.value();
      }
    }
    pack(L, s, block.data(), height);
  }
  return L;
}

}  // namespace

std::optional<Cholesky> simplicial_cholesky(const Matrix& matrix, const Permutation& order) {
  Cholesky result{in_postorder(matrix, order), {}};
  Matrix ordered(matrix.rows(), matrix.cols());
  ordered.selfadjointView<Eigen::Upper>() = matrix.selfadjointView<Eigen::Upper>().twistedBy(result.order);
  const SimplicialCholesky factored(ordered);
  if (factored.info() != Eigen::Success) return std::nullopt;
  result.L = supernodes_of(factored.matrixL().nestedExpression());
  return result;
}

}  // namespace flexkey
