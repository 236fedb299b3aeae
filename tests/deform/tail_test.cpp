#include "flexkey/deform/tail.h"

#include <gtest/gtest.h>

#include <cmath>

namespace flexkey {
namespace {

TEST(GeometricTail, OfAGeometricSeriesIsExact) {
  for (const double q : {0.1, 0.5, 0.99}) {
    GeometricTail tail;
    double left = 1 / (1 - q);
    for (int k = 0; k < 20; ++k) {
      const double step = std::pow(q, k);
      left -= step;
      const double estimate = tail.after(step);
      if (k < 2) continue;
      EXPECT_NEAR(estimate, left, 1e-9);
    }
  }
}

TEST(GeometricTail, SaysNothingBeforeTheThirdStep) {
  GeometricTail tail;
  EXPECT_TRUE(std::isinf(tail.after(1)));
  EXPECT_TRUE(std::isinf(tail.after(0.01)));
  EXPECT_FALSE(std::isinf(tail.after(0.001)));
}

TEST(GeometricTail, TrustsTheSlowerOfTheLastTwoRatios) {
  GeometricTail tail;
  tail.after(1);
  tail.after(0.5);
  EXPECT_DOUBLE_EQ(tail.after(0.005), 0.005);
}

TEST(GeometricTail, IsInfiniteWhileStepsGrow) {
  GeometricTail tail;
  tail.after(1);
  tail.after(0.5);
  EXPECT_TRUE(std::isinf(tail.after(0.6)));
}

TEST(GeometricTail, IsZeroAfterNoStep) {
  GeometricTail tail;
  EXPECT_EQ(tail.after(0), 0);
}

}  // namespace
}  // namespace flexkey
