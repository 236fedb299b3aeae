#include "flexkey/preview/legend.h"

#include <gtest/gtest.h>

#include <array>

#include "support/meshes.h"

namespace flexkey {
namespace {

TEST(Legend, TheTopIsRoundAndAboveEveryDistance) {
  const Positions rest = meshes::cube().positions;  // of diagonal sqrt(3)
  const std::array<Positions, 2> frames{rest, rest.array() + 0.3};
  EXPECT_NEAR(displacement_top(rest, frames), 0.5, 1e-12);  // 0.3 of the diagonal
  EXPECT_NEAR(displacement_top(rest, std::span(frames).first(1)), 1e-3, 1e-12);
}

TEST(Legend, OnlyMeasuresHaveOne) {
  RenderOptions options;
  EXPECT_FALSE(legend_of(options));
  options.style = Style::displacement;
  options.displacement_top = 0.2;
  ASSERT_TRUE(legend_of(options));
  EXPECT_NEAR(legend_of(options)->high, 20, 1e-12);
  EXPECT_EQ(legend_of(options)->colour(1), viridis(1));
}

TEST(Colour, ViridisGrowsLighterAllTheWay) {
  float last = -1;
  for (int k = 0; k <= 100; ++k) {
    const float light = viridis(static_cast<float>(k) / 100).dot(Rgb(0.2126f, 0.7152f, 0.0722f));
    EXPECT_GT(light, last) << k;
    last = light;
  }
}

}  // namespace
}  // namespace flexkey
