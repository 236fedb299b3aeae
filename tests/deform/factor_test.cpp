#include "flexkey/deform/factor.h"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <thread>
#include <vector>

#include "deform/matrices.h"
#include "flexkey/deform/error.h"

namespace flexkey {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// 1D Laplacian with both ends held, plus `diagonal`; n x n.
Matrix chain(int n, double diagonal) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, diagonal);
    if (i > 0) entries.emplace_back(i, i - 1, -1);
    if (i > 0) entries.emplace_back(i - 1, i, -1);
  }
  Matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// n x n, everything joined to everything.
Matrix dense(int n) {
  const Eigen::MatrixXd half = Eigen::MatrixXd::Random(n, n);
  const Eigen::MatrixXd whole = half * half.transpose() + n * Eigen::MatrixXd::Identity(n, n);
  return whole.sparseView();
}

Permutation natural(const Matrix& matrix) {
  Permutation order(matrix.rows());
  order.setIdentity();
  return order;
}

std::vector<Matrix> matrices() {
  return {chain(1, 2.1),
          chain(2, 2.1),
          chain(3, 2.1),
          chain(200, 2.1),
          dense(5),
          dense(40),
          grid(1, 30),
          grid(17, 23),
          squared(grid(17, 23)),
          islands(),
          dense(131),
          chain(8, 1e12),
          squared(grid(60, 40)),
          squared(squared(grid(9, 9)))};
}

/// Large enough to be shared out among threads.
Matrix large() {
  return squared(grid(120, 130));
}

Eigen::MatrixXd by_eigen(const Matrix& matrix, const Eigen::MatrixXd& b) {
  return Eigen::SimplicialLDLT<Matrix>(matrix).solve(b);
}

TEST(Factor, SolvesThreeColumnsAtOnce) {
  for (const Matrix& matrix : matrices()) {
    const Positions b = Positions::Random(matrix.rows(), 3);
    const Positions x = Factor(matrix).solve(b);
    EXPECT_LT((x - by_eigen(matrix, b)).norm(), 1e-9 * x.norm()) << matrix.rows();
    EXPECT_LT((matrix * x - b).norm(), 1e-12 * matrix.norm() * x.norm()) << matrix.rows();
  }
}

TEST(Factor, SolvesAnyNumberOfColumns) {
  for (const int columns : {0, 1, 2, 4, 5, 8, 9, 16, 17, 40}) {
    const Matrix matrix = grid(13, 12);
    const Eigen::MatrixXd b = Eigen::MatrixXd::Random(matrix.rows(), columns);
    const Eigen::MatrixXd x = Factor(matrix).solve(b);
    ASSERT_EQ(x.cols(), columns);
    EXPECT_LE((matrix * x - b).norm(), 1e-13 * matrix.norm() * x.norm()) << columns;
  }
}

TEST(Factor, OfNothingSolvesNothing) {
  const Factor factor(Matrix(0, 0));
  EXPECT_EQ(factor.solve(Positions(0, 3)).rows(), 0);
  EXPECT_EQ(factor.solve(Eigen::MatrixXd(0, 2)).cols(), 2);
}

TEST(Factor, EliminatesInTheOrderGiven) {
  for (const Matrix& matrix : matrices()) {
    const Positions b = Positions::Random(matrix.rows(), 3);
    const Positions x = Factor(matrix, natural(matrix)).solve(b);
    EXPECT_LT((matrix * x - b).norm(), 1e-12 * matrix.norm() * x.norm()) << matrix.rows();
  }
  // An arrow that points to the last row has no fill in the natural order; the other way round it is full.
  Matrix arrow = chain(300, 400);
  for (int i = 0; i + 2 < 300; ++i) arrow.coeffRef(i, 299) = arrow.coeffRef(299, i) = -1;
  Permutation reverse(300);
  for (int i = 0; i < 300; ++i) reverse.indices()[i] = 299 - i;
  EXPECT_GT(Factor(arrow, reverse).bytes(), 10 * Factor(arrow, natural(arrow)).bytes());
}

TEST(Factor, SolvesSharedOutAsItSolvesWhole) {
  const Matrix matrix = large();
  const Positions b = Positions::Random(matrix.rows(), 3);
  const Positions x = Factor(matrix).solve(b);
  EXPECT_LT((x - by_eigen(matrix, b)).norm(), 1e-8 * x.norm());
}

TEST(Factor, GivesTheSameBytesWithOneThreadAndMany) {
  const Factor factor(large());
  const Positions b = Positions::Random(large().rows(), 3);
  const Positions many = factor.solve(b);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(factor.solve(b), many);
}

TEST(Factor, MadeBesideOthersIsTheOneMadeAlone) {
  const Positions b = Positions::Random(large().rows(), 3);
  const Positions alone = Factor(large()).solve(b);
  std::vector<Positions> beside(4);
  std::vector<std::thread> threads;
  for (Positions& x : beside) threads.emplace_back([&] { x = Factor(large()).solve(b); });
  for (std::thread& thread : threads) thread.join();
  for (const Positions& x : beside) EXPECT_EQ(x, alone);
}

TEST(Factor, SolvesABatchAsItSolvesEachAlone) {
  for (const Matrix& matrix : {grid(30, 20), large()}) {
    const Factor factor(matrix);
    Factor::Workspace workspace;
    for (const int count : {0, 1, 2, 3, 4, 5, 6, 11}) {
      std::vector<Positions> b(count);
      for (Positions& each : b) each = Positions::Random(matrix.rows(), 3);
      std::vector<Positions> x = b;
      factor.solve_in_place(x, workspace);
      for (int k = 0; k < count; ++k) {
        const Positions alone = factor.solve(b[k]);
        EXPECT_LT((x[k] - alone).norm(), 1e-12 * alone.norm()) << k << " of " << count;
      }
    }
  }
}

TEST(Factor, WorksInTheSameRoomAgain) {
  const Factor factor(large());
  Factor::Workspace workspace;
  std::vector<Positions> b(2, Positions::Random(large().rows(), 3));
  const Positions x = factor.solve(b[0]);
  factor.solve_in_place({b.data(), 1}, workspace);
  EXPECT_EQ(b[0], x);
  factor.solve_in_place(b, workspace);
  const auto* room = workspace.lines.data();
  b[0] = b[1] = x;
  factor.solve_in_place(b, workspace);
  factor.solve_in_place({b.data(), 1}, workspace);
  EXPECT_EQ(workspace.lines.data(), room);
}

TEST(Factor, HoldsHardlyMoreThanItsNumbers) {
  const Matrix matrix = large();
  const Matrix lower =
      Eigen::SimplicialLLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>>(matrix).matrixL();
  const std::size_t numbers = static_cast<std::size_t>(lower.nonZeros()) * sizeof(double);
  const std::size_t held = Factor(matrix, natural(matrix)).bytes();
  EXPECT_GT(held, numbers);
  EXPECT_LT(held, numbers + numbers / 5);
}

void expect_refused(const Matrix& matrix) {
  try {
    const Factor factor(matrix);
    ADD_FAILURE() << "a matrix that has no factor was factored";
  } catch (const DeformError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("singular to working precision"));
  }
}

TEST(Factor, RefusesSingularIndefiniteAndNonFiniteMatrices) {
  expect_refused(chain(2, 1));
  expect_refused(chain(5, 0.5));
  expect_refused(chain(4, std::nan("")));
  expect_refused(chain(4, HUGE_VAL));
  expect_refused(grid(20, 20, 0));
  expect_refused(Matrix(3, 3));
}

}  // namespace
}  // namespace flexkey
