#include "flexkey/gltf/float_grid.h"

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace flexkey::testing {
namespace {

std::span<const unsigned char> bytes_of(const std::vector<float>& values) {
  return {reinterpret_cast<const unsigned char*>(values.data()), values.size() * sizeof(float)};
}

/// What a client's decoder makes of the integers.
std::vector<float> decoded(std::vector<unsigned char> integers) {
  meshopt_decodeFilterExp(integers.data(), integers.size() / sizeof(float), sizeof(float));
  std::vector<float> values(integers.size() / sizeof(float));
  std::memcpy(values.data(), integers.data(), integers.size());
  return values;
}

TEST(FloatGrid, RoundsToTheNearestMultiple) {
  FloatRows rows(1, 3);
  rows << 0.3F, -0.4F, 1000.1F;
  const FloatRows grid = on_grid(rows, 0.25);
  EXPECT_EQ(grid(0, 0), 0.25F);
  EXPECT_EQ(grid(0, 1), -0.5F);
  EXPECT_EQ(grid(0, 2), 1000.0F);
}

TEST(FloatGrid, StepsArePowersOfTwo) {
  EXPECT_EQ(power_of_two_below(1), 1);
  EXPECT_EQ(power_of_two_below(0.3), 0.25);
  EXPECT_EQ(power_of_two_below(7), 4);
}

TEST(FloatGrid, IntegersDecodeToTheSameFloats) {
  for (const double step : {std::exp2(-20), 1.0 / 256, 1.0, 64.0}) {
    std::vector<float> values = {0, static_cast<float>(step)};
    for (int i = -3000; i < 3000; i += 7) values.push_back(static_cast<float>(step * i));
    const auto integers = grid_integers(bytes_of(values));
    ASSERT_TRUE(integers.has_value()) << step;
    EXPECT_EQ(decoded(*integers), values) << step;
  }
}

TEST(FloatGrid, ZerosAreOnEveryGrid) {
  const std::vector<float> zeros(12, 0.0F);
  const auto integers = grid_integers(bytes_of(zeros));
  ASSERT_TRUE(integers.has_value());
  EXPECT_EQ(decoded(*integers), zeros);
}

TEST(FloatGrid, FloatsOfNoCommonGridAreLeft) {
  EXPECT_FALSE(grid_integers(bytes_of({0.1F, 1000.0F})));
  EXPECT_FALSE(grid_integers(bytes_of({1, std::numeric_limits<float>::infinity()})));
  EXPECT_FALSE(grid_integers(bytes_of({1, std::nanf("")})));
  EXPECT_FALSE(grid_integers(bytes_of({std::numeric_limits<float>::denorm_min()})));
  EXPECT_FALSE(grid_integers(bytes_of({1, 8388608.0F})));
}

}  // namespace
}  // namespace flexkey::testing
