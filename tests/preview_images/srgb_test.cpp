#include "flexkey/preview/images/srgb.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace flexkey {
namespace {

// From the formula of IEC 61966-2-1, by hand: 1.055 * x^(1/2.4) - 0.055, and 12.92 x below 0.0031308.
TEST(Srgb, MeetsTheStandardsCurve) {
  EXPECT_FLOAT_EQ(srgb_from_linear(0), 0);
  EXPECT_FLOAT_EQ(srgb_from_linear(0.002f), 0.02584f);
  EXPECT_NEAR(srgb_from_linear(0.18f), 0.461356f, 1e-5);
  EXPECT_NEAR(srgb_from_linear(0.5f), 0.735357f, 1e-5);
  EXPECT_NEAR(srgb_from_linear(1), 1, 1e-6);
}

TEST(Srgb, ItsInverseLeadsBackForEveryByte) {
  for (int value = 0; value < 256; ++value) {
    const float encoded = static_cast<float>(value) / 255;
    EXPECT_NEAR(srgb_from_linear(linear_from_srgb(encoded)), encoded, 1e-5) << value;
  }
}

TEST(Srgb, BytesAreTheNearestAndClamped) {
  const float infinity = std::numeric_limits<float>::infinity();
  const Picture picture{
      2, 2, {0.18f, 0.5f, 1, -1, 7, 0, std::nanf(""), infinity, -infinity, 0.002f, 0.0f, 0.001f}};
  EXPECT_THAT(srgb_bytes(picture), testing::ElementsAre(118, 188, 255, 0, 255, 0, 0, 255, 0, 7, 0, 3));
}

}  // namespace
}  // namespace flexkey
