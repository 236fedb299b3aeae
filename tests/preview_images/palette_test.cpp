#include "flexkey/preview/images/palette.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "flexkey/preview/images/dither.h"

namespace flexkey {
namespace {

std::vector<std::uint8_t> repeated(std::vector<std::uint8_t> rgb, int times) {
  std::vector<std::uint8_t> pixels;
  for (int i = 0; i < times; ++i) pixels.insert(pixels.end(), rgb.begin(), rgb.end());
  return pixels;
}

TEST(Palette, KeepsFewColoursAsTheyAre) {
  ColourCount count;
  count.add(repeated({10, 20, 30}, 1000));
  count.add(repeated({200, 100, 50}, 3));
  count.add(repeated({255, 255, 255}, 70));
  EXPECT_THAT(make_palette(count.samples(), 255),
              testing::UnorderedElementsAre(Srgb{10, 20, 30}, Srgb{200, 100, 50}, Srgb{255, 255, 255}));
}

TEST(Palette, GivesASmallMarkAColourBesideALargeGradient) {
  ColourCount count;
  for (int grey = 0; grey < 256; ++grey) {
    const auto value = static_cast<std::uint8_t>(grey);
    count.add(repeated({value, value, value}, 2000));
  }
  count.add(repeated({30, 60, 220}, 40));
  const std::vector<Srgb> palette = make_palette(count.samples(), 16);
  EXPECT_EQ(palette.size(), 16u);
  EXPECT_THAT(palette, testing::Contains(Srgb{30, 60, 220}));
}

TEST(Palette, OfNothingIsEmpty) {
  EXPECT_TRUE(make_palette(ColourCount().samples(), 255).empty());
}

TEST(Dither, MixesTwoColoursToTheMeanThatIsAskedFor) {
  const std::vector<Srgb> colours{{100, 100, 100}, {140, 140, 140}, {255, 0, 0}};
  Dither dither(colours);
  for (const int value : {100, 110, 120, 131, 140}) {
    const std::vector<std::uint8_t> rgb(3, static_cast<std::uint8_t>(value));
    double sum = 0;
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) sum += colours.at(dither.index(rgb.data(), x, y))[0];
    EXPECT_NEAR(sum / 64, value, 1.5);
  }
}

TEST(Dither, MarksOfAPatternLieEvenly) {
  Dither dither({{0, 0, 0}, {64, 64, 64}});
  const std::uint8_t quarter[3] = {16, 16, 16};
  for (int block = 0; block < 16; ++block) {  // a quarter of the pixels: one in each square of 2 x 2
    int bright = 0;
    for (int i = 0; i < 4; ++i) bright += dither.index(quarter, block % 4 * 2 + i % 2, block / 4 * 2 + i / 2);
    EXPECT_NEAR(bright, 1, 1) << block;
  }
}

}  // namespace
}  // namespace flexkey
