#include "flexkey/deform/anderson.h"

#include <gtest/gtest.h>

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
  EXPECT_EQ(Anderson(5).next(x, f), Positions(x + f));
}

TEST(Anderson, NeedsFarFewerStepsThanThePlainIteration) {
  const Contraction contraction;
  Anderson anderson(5);
  Positions accelerated = Positions::Zero(4, 3), plain = accelerated;
  for (int k = 0; k < 40; ++k) {
    accelerated = anderson.next(accelerated, contraction.residual(accelerated));
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
  for (int k = 0; k < 8; ++k) x = anderson.next(x, contraction.residual(x));
  const double left = (x - contraction.fixed_point).norm(), residual = contraction.residual(x).norm();
  EXPECT_GT(anderson.stretch(), 1);
  EXPECT_LT(anderson.stretch(), 51);  // 1 / (1 - 0.98): no difference can promise more
  EXPECT_LT(left, 10 * anderson.stretch() * residual);
}

TEST(Anderson, TakesThePlainStepWhereAMixtureMadeItWorse) {
  Anderson anderson(5);
  const Positions x = Positions::Random(4, 3), f = Positions::Random(4, 3);
  anderson.next(x, f);
  const Positions worse = 100 * f;
  EXPECT_EQ(anderson.next(x + f, worse), Positions(x + f + worse));
}

TEST(Anderson, StaysFiniteWhereNothingChanges) {
  Anderson anderson(5);
  const Positions x = Positions::Random(4, 3), f = Positions::Zero(4, 3);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(anderson.next(x, f), x);
}

}  // namespace
}  // namespace flexkey
