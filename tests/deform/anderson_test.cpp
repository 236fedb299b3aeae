#include "flexkey/deform/anderson.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Dense>
#include <vector>

namespace flexkey {
namespace {

/// G(x) = A x + b on 4 points, a slow contraction whose fixed point is known.
struct Contraction {
  Eigen::VectorXd rates = Eigen::VectorXd::LinSpaced(12, 0.1, 0.98);
  Positions fixed_point = Positions::Random(4, 3);

  Positions residual(const Positions& x) const {
    Positions f = fixed_point - x;
    for (Eigen::Index k = 0; k < f.size(); ++k) f.data()[k] *= 1 - rates[k];
    return f;
  }
};

TEST(Anderson, TheFirstStepIsThePlainOne) {
  const Positions x = Positions::Random(4, 3), f = Positions::Random(4, 3);
  Anderson anderson(5);
  EXPECT_EQ(anderson.next(x, f).positions, Positions(x + f));
}

TEST(Anderson, NeedsFarFewerStepsThanThePlainIteration) {
  const Contraction contraction;
  Anderson anderson(5);
  Positions accelerated = Positions::Zero(4, 3), plain = accelerated;
  for (int k = 0; k < 40; ++k) {
    accelerated = anderson.next(accelerated, contraction.residual(accelerated)).positions;
    plain += contraction.residual(plain);
  }
  EXPECT_LT((accelerated - contraction.fixed_point).norm(), 1e-4);
  EXPECT_GT((plain - contraction.fixed_point).norm(), 1e-2);
}

TEST(Anderson, TheStretchTellsHowFarTheFixedPointIs) {
  const Contraction contraction;
  Anderson anderson(5);
  Positions x = Positions::Zero(4, 3);
  EXPECT_EQ(anderson.stretch(), 0);
  for (int k = 0; k < 8; ++k) x = anderson.next(x, contraction.residual(x)).positions;
  const double left = (x - contraction.fixed_point).norm(), residual = contraction.residual(x).norm();
  EXPECT_GT(anderson.stretch(), 1);
  EXPECT_LT(anderson.stretch(), 51);  // 1 / (1 - 0.98): no difference can promise more
  EXPECT_LT(left, 10 * anderson.stretch() * residual);
}

TEST(Anderson, ASlowDirectionHiddenAmongFastOnesShowsAndIsRemembered) {
  Contraction contraction;
  contraction.rates = Eigen::VectorXd::LinSpaced(12, 0.05, 0.3);
  contraction.rates[0] = 0.98;
  contraction.fixed_point.setOnes();
  contraction.fixed_point(0, 0) = 0.1;
  Anderson anderson(8);
  Positions x = Positions::Zero(4, 3);
  for (int k = 0; k < 2; ++k) x = anderson.next(x, contraction.residual(x)).positions;
  EXPECT_LT(anderson.stretch(), 2);
  for (int k = 0; k < 6; ++k) x = anderson.next(x, contraction.residual(x)).positions;
  const double learned = anderson.stretch();
  EXPECT_GT(learned, 40);
  EXPECT_LT(learned, 51);
  anderson.turn_to_next_map();
  contraction.fixed_point.array() += 0.5;
  for (int k = 0; k < 2; ++k) x = anderson.next(x, contraction.residual(x)).positions;
  EXPECT_GE(anderson.stretch(), learned);
}

/// Iterates and residuals of a slow contraction on n points, as the first few calls meet them.
struct Walk {
  std::vector<Positions> x, f;
};
Walk walk(int n, int steps) {
  const Eigen::VectorXd rates = Eigen::VectorXd::LinSpaced(3 * n, 0.2, 0.95);
  Walk path{{Positions::Random(n, 3)}, {}};
  for (int k = 0; k < steps; ++k) {
    Positions f = -path.x.back();
    for (Eigen::Index i = 0; i < f.size(); ++i) f.data()[i] *= 1 - rates[i];
    path.x.push_back(path.x.back() + f + 0.01 * Positions::Random(n, 3));
    path.f.push_back(f);
  }
  return path;
}

/// x + f less the ΔG that cancel f best, by a dense QR of the last `window` differences.
Positions mixture(const Walk& path, int window) {
  const auto last = static_cast<int>(path.f.size()) - 1;
  Eigen::MatrixXd F(path.f[0].size(), window);
  const auto flat = [](const Positions& p) { return Eigen::VectorXd(p.reshaped<Eigen::RowMajor>()); };
  for (int k = 0; k < window; ++k) F.col(k) = flat(path.f[last - k] - path.f[last - k - 1]);
  const Eigen::VectorXd gamma = F.colPivHouseholderQr().solve(flat(path.f[last]));
  Positions mixed = path.x[last] + path.f[last];
  for (int k = 0; k < window; ++k) {
    const int a = last - k;
    mixed -= gamma[k] * (path.x[a] + path.f[a] - path.x[a - 1] - path.f[a - 1]);
  }
  return mixed;
}

TEST(Anderson, MixesAsTheLeastSquaresSolutionSays) {
  for (const int n : {4, 171, 1000}) {
    for (const int steps : {2, 4, 9}) {
      const Walk path = walk(n, steps);
      Anderson anderson(5);
      Positions mixed;
      for (int k = 0; k < steps; ++k) mixed = anderson.next(path.x[k], path.f[k]).positions;
      EXPECT_LT((mixed - mixture(path, std::min(5, steps - 1))).norm(), 1e-10 * mixed.norm())
          << n << " " << steps;
    }
  }
}

TEST(Anderson, ADifferenceWithinTheNewerOnesChangesNothing) {
  const Walk path = walk(20, 2);
  const Positions along = path.f[1] - path.f[0], step = path.x[1] - path.x[0];
  Anderson three(3), one(1);
  Positions mixed, expected;
  for (int k = 0; k < 4; ++k)
    mixed = three.next(path.x[0] + k * step, path.f[0] + 1e-3 * k * along).positions;
  for (int k = 2; k < 4; ++k)
    expected = one.next(path.x[0] + k * step, path.f[0] + 1e-3 * k * along).positions;
  EXPECT_LT((mixed - expected).norm(), 1e-9 * expected.norm());
}

TEST(Anderson, GivesTheSameBytesOnAnyNumberOfThreads) {
  const Walk path = walk(20000, 7);
  std::vector<Positions> mixed;
  for (const std::size_t threads : {1, 2, 5}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    Anderson anderson(5);
    for (int k = 0; k < 7; ++k) mixed.push_back(anderson.next(path.x[k], path.f[k]).positions);
  }
  for (std::size_t k = 7; k < mixed.size(); ++k) EXPECT_EQ(mixed[k], mixed[k % 7]);
}

TEST(Anderson, TakesThePlainStepWhereAMixtureMadeItWorse) {
  Anderson anderson(5);
  const Positions x = Positions::Random(4, 3), f = Positions::Random(4, 3);
  anderson.next(x, f);
  const Positions worse = 100 * f;
  EXPECT_EQ(anderson.next(x + f, worse).positions, Positions(x + f + worse));
}

TEST(Anderson, StaysFiniteWhereNothingChanges) {
  Anderson anderson(5);
  const Positions x = Positions::Random(4, 3), f = Positions::Zero(4, 3);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(anderson.next(x, f).positions, x);
}

}  // namespace
}  // namespace flexkey
