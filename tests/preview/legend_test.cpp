#include "flexkey/preview/legend.h"

#include <gtest/gtest.h>

namespace flexkey {
namespace {

TEST(Legend, TheTopIsRoundAndAboveEveryDistance) {
  EXPECT_NEAR(displacement_top(0.6, 2), 0.5, 1e-12);  // 0.3 of the diagonal
  EXPECT_NEAR(displacement_top(0.4, 2), 0.2, 1e-12);
  EXPECT_NEAR(displacement_top(0, 2), 1e-3, 1e-12);
  EXPECT_NEAR(displacement_top(0, 0), 1e-3, 1e-12);
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

TEST(Colour, IsTheLinearLightOfItsBytes) {
  const Rgb colour = colour_from_srgb(255, 188, 0);
  EXPECT_FLOAT_EQ(colour[0], 1);
  EXPECT_NEAR(colour[1], 0.5, 0.005);
  EXPECT_EQ(colour[2], 0);
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
