#include "flexkey/deform/factor.h"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <vector>

#include "flexkey/deform/error.h"

namespace flexkey {
namespace {

/// 1D Laplacian with both ends held, plus `diagonal`; n x n.
Eigen::SparseMatrix<double> chain(int n, double diagonal) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, diagonal);
    if (i > 0) entries.emplace_back(i, i - 1, -1);
    if (i > 0) entries.emplace_back(i - 1, i, -1);
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

TEST(Factor, SolvesThreeColumnsAtOnce) {
  for (const int n : {1, 2, 3, 10, 200}) {
    const Eigen::SparseMatrix<double> matrix = chain(n, 2.1);
    const Positions b = Positions::Random(n, 3);
    const Positions x = Factor(matrix).solve(b);
    EXPECT_LT((matrix * x - b).norm(), 1e-12 * b.norm()) << n;
  }
}

TEST(Factor, OfNothingSolvesNothing) {
  EXPECT_EQ(Factor(Eigen::SparseMatrix<double>(0, 0)).solve(Positions(0, 3)).rows(), 0);
}

TEST(Factor, SolvesBlocksThatDoNotTouch) {
  Eigen::SparseMatrix<double> matrix(5, 5);
  for (int k = 0; k < 5; ++k) matrix.insert(k, k) = k + 1;
  EXPECT_LT(
      (Factor(matrix).solve(Positions::Ones(5, 3)).col(0).array() * Eigen::ArrayXd::LinSpaced(5, 1, 5) - 1)
          .abs()
          .maxCoeff(),
      1e-15);
}

void expect_refused(const Eigen::SparseMatrix<double>& matrix) {
  try {
    const Factor factor(matrix);
    ADD_FAILURE() << "a matrix that has no factor was factored";
  } catch (const DeformError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("singular to working precision"));
  }
}

TEST(Factor, RefusesSingularIndefiniteAndNonFiniteMatrices) {
  Eigen::SparseMatrix<double> singular = chain(2, 1);
  expect_refused(singular);
  expect_refused(chain(5, 0.5));
  expect_refused(chain(4, std::nan("")));
  expect_refused(chain(4, HUGE_VAL));
}

}  // namespace
}  // namespace flexkey
