#include "flexkey/deform/cholesky.h"

#include <Eigen/Dense>
#include <algorithm>
#include <vector>

#include "deform/matrices.h"
#include "flexkey/deform/elimination_tree.h"
#include "flexkey/deform/partition.h"
#include "flexkey/deform/sweep.h"

namespace flexkey {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// L as the comment on Supernodes says that it is stored.
Eigen::MatrixXd dense(const Supernodes& L) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(L.size(), L.size());
  for (int s = 0; s < L.count(); ++s) {
    std::vector<int> rows;
    for (int k = L.columns[s]; k < L.columns[s + 1]; ++k) rows.push_back(k);
    auto panel = [&, at = L.values.data() + L.value_offsets[s]](int first, int height, int width) mutable {
      for (int c = 0; c < width; ++c) {
        for (int r = 0; r < height; ++r) result(rows[first + r], rows[c]) = *at++;
      }
      for (int c = width; c < std::min(first + height, L.width(s)); ++c) {
        result(rows[c], rows[c]) = 1 / *at++;
        for (int r = c - first + 1; r < height; ++r) result(rows[first + r], rows[c]) = *at++;
      }
    };
    for (int r = 0; r < L.width(s); r += 8) panel(r, std::min(8, L.width(s) - r), r);
    rows.insert(rows.end(), L.rows.begin() + L.row_offsets[s], L.rows.begin() + L.row_offsets[s + 1]);
    for (int r = L.width(s); r < static_cast<int>(rows.size()); r += 8) {
      panel(r, std::min(8, static_cast<int>(rows.size()) - r), L.width(s));
    }
  }
  return result;
}

void expect_factored(const Matrix& matrix, const std::optional<Cholesky>& factored) {
  ASSERT_TRUE(factored.has_value());
  const Eigen::MatrixXd L = dense(factored->L);
  const Eigen::MatrixXd ordered = factored->order * Eigen::MatrixXd(matrix) * factored->order.inverse();
  EXPECT_LT((L * L.transpose() - ordered).norm(), 1e-13 * ordered.norm());
  EXPECT_EQ(diagonal(factored->L), Eigen::VectorXd(L.diagonal()));
  for (int s = 0; s < factored->L.count(); ++s) {
    const auto first = factored->L.rows.begin() + factored->L.row_offsets[s];
    const auto end = factored->L.rows.begin() + factored->L.row_offsets[s + 1];
    EXPECT_TRUE(std::is_sorted(first, end));
    EXPECT_TRUE(first == end || *first >= factored->L.columns[s + 1]);
  }
}

std::vector<Matrix> matrices() {
  return {
      grid(1, 1), grid(1, 12), grid(11, 13), squared(grid(11, 13)), islands(), squared(squared(grid(8, 8)))};
}

TEST(Cholesky, OfEitherBackendIsTheMatrix) {
  for (const Matrix& matrix : matrices()) {
    const Permutation order = fill_reducing_order(matrix);
    expect_factored(matrix, cholesky(matrix, order));
    expect_factored(matrix, simplicial_cholesky(matrix, order));
  }
}

TEST(Cholesky, OfAnIndefiniteMatrixIsNothing) {
  for (const double spring : {-1.0, -0.5}) {
    const Matrix matrix = grid(7, 7, spring);
    const Permutation order = fill_reducing_order(matrix);
    EXPECT_FALSE(cholesky(matrix, order).has_value());
    EXPECT_FALSE(simplicial_cholesky(matrix, order).has_value());
  }
}

TEST(Cholesky, StoresFewZeros) {
  const Matrix matrix = squared(grid(60, 60));
  const Permutation order = fill_reducing_order(matrix);
  for (const auto& factored : {cholesky(matrix, order), simplicial_cholesky(matrix, order)}) {
    const Supernodes& L = factored->L;
    const auto zeros = std::count(L.values.begin(), L.values.end(), 0.0);
    EXPECT_LT(zeros, 0.15 * static_cast<double>(L.values.size()));
    EXPECT_LT(L.count(), L.size() / 4);
  }
}

TEST(EliminationTree, LeadsToTheFirstRowBelowTheDiagonal) {
  for (const Matrix& matrix : matrices()) {
    const Permutation order = fill_reducing_order(matrix);
    const Eigen::MatrixXd ordered = order * Eigen::MatrixXd(matrix) * order.inverse();
    const Eigen::MatrixXd L = ordered.llt().matrixL();
    const std::vector<int> parents = elimination_tree(matrix, order);
    for (int k = 0; k < L.cols(); ++k) {
      int first = k + 1;
      while (first < L.rows() && L(first, k) == 0) ++first;
      EXPECT_EQ(parents[k], first < L.rows() ? first : -1);
    }
  }
}

TEST(EliminationTree, IsInPostorderWhenEachSubtreeEndsAtItsRoot) {
  const std::vector<int> parents = {4, 4, 3, 5, 5, -1, 8, 8, -1};
  const std::vector<int> places = postorder(parents);
  std::vector<int> sizes(parents.size(), 1);
  for (std::size_t node = 0; node < parents.size(); ++node) {
    if (parents[node] >= 0) sizes[parents[node]] += sizes[node];
  }
  for (std::size_t node = 0; node < parents.size(); ++node) {
    EXPECT_EQ(std::count(places.begin(), places.end(), static_cast<int>(node)), 1);
    for (int up = parents[node]; up >= 0; up = parents[up]) {
      EXPECT_LT(places[node], places[up]);
      EXPECT_GT(places[node], places[up] - sizes[up]);
    }
  }
}

SupernodeView view_of(const Supernodes& L) {
  return {L.columns.data(), L.row_offsets.data(), L.rows.data(), L.value_offsets.data(), L.values.data()};
}

TEST(Sweeps, OfEveryProcessorSubstituteAsADenseTriangleDoes) {
  const SweepChoice choice = sweeps_for_this_processor();
  for (const Matrix& matrix : matrices()) {
    const Supernodes L = simplicial_cholesky(matrix, fill_reducing_order(matrix))->L;
    const Eigen::MatrixXd triangle = dense(L);
    for (int kind = 0; kind < choice.count; ++kind) {
      for (int width = 0; width < 3; ++width) {
        using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
        const Rows b = Rows::Random(L.size(), 4 << width);
        Rows x = b;
        choice.sweeps[kind]->forward[width](view_of(L), 0, L.count(), x.data());
        EXPECT_LT((triangle * x - b).norm(), 1e-12 * b.norm()) << choice.sweeps[kind]->name;
        choice.sweeps[kind]->backward[width](view_of(L), 0, L.count(), x.data());
        EXPECT_LT((triangle * triangle.transpose() * x - b).norm(), 1e-13 * triangle.squaredNorm() * x.norm())
            << choice.sweeps[kind]->name;
      }
    }
  }
}

/// The column that a row of x stands for in a piece.
int column_of(const Piece& piece, int row) {
  return row < piece.copies ? row : piece.border[static_cast<std::size_t>(row - piece.copies)];
}

TEST(Partition, CutsTheTreeIntoPiecesThatDoNotTouch) {
  for (const Matrix& matrix : {squared(grid(120, 130)), squared(grid(130, 120)), grid(3, 3), islands()}) {
    Supernodes L = cholesky(matrix, fill_reducing_order(matrix))->L;
    const std::vector<int> rows = L.rows;
    const Partition shares = partition(L);
    EXPECT_EQ(shares.pieces.size() > 8, matrix.rows() > 1000);
    int supernodes = 0;
    int x_rows = L.size();
    for (const Piece& piece : shares.pieces) {
      EXPECT_TRUE(piece.first == supernodes || piece.below.empty() || piece.first == piece.end);
      supernodes += piece.end - piece.first;
      EXPECT_EQ(piece.copies, x_rows);
      x_rows += static_cast<int>(piece.border.size());
      for (auto at = L.row_offsets[piece.first]; at < L.row_offsets[piece.end]; ++at) {
        EXPECT_EQ(column_of(piece, L.rows[at]), rows[at]);
        const bool is_own = rows[at] >= L.columns[piece.first] && rows[at] < L.columns[piece.end];
        EXPECT_EQ(is_own, L.rows[at] == rows[at]);
      }
      for (const int below : piece.below) {
        const Piece& child = shares.pieces[below];
        ASSERT_EQ(child.originals.size(), child.border.size());
        for (std::size_t i = 0; i < child.border.size(); ++i) {
          EXPECT_EQ(column_of(piece, child.originals[i]), child.border[i]);
          EXPECT_GE(child.border[i], L.columns[piece.first]);
        }
      }
    }
    EXPECT_EQ(supernodes, L.count());
    EXPECT_EQ(x_rows, shares.rows);
    EXPECT_TRUE(shares.pieces.back().border.empty());
  }
}

}  // namespace
}  // namespace flexkey
