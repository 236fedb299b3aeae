#include "flexkey/preview/images/overlay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "flexkey/preview/images/draw.h"
#include "flexkey/preview/images/draw_legend.h"
#include "flexkey/preview/images/text.h"
#include "preview_images/test_folder.h"

namespace flexkey {
namespace {

using Overlay = test::TestFolder;
const Rgb grey(0.5f, 0.5f, 0.5f);

/// From blue to red.
Rgb cold_to_hot(float share) {
  return {share, 0, 1 - share};
}

const float* pixel(const Picture& picture, int x, int y) {
  return &picture.rgb[static_cast<std::size_t>(y * picture.width + x) * 3];
}

/// λ from 0 to 1 over 48 frames.
std::vector<Moment> rising() {
  std::vector<Moment> clip;
  for (int k = 0; k <= 48; ++k) clip.push_back({k, k / 24.0, k / 48.0});
  return clip;
}

/// The middle of the pixels that are clearly red right of the text: the playhead's dot.
Point playhead_of(const Picture& picture) {
  Point sum;
  double count = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 240; x < picture.width; ++x) {
      if (pixel(picture, x, y)[0] < 0.6f || pixel(picture, x, y)[2] > 0.05f) continue;
      sum = {sum.x + x, sum.y + y};
      ++count;
    }
  return {sum.x / count, sum.y / count};
}

Picture overlaid(const Moment& now) {
  Picture picture = blank_picture(960, 540, grey);
  draw_overlay(picture, rising(), now);
  return picture;
}

TEST_F(Overlay, LiesAlongTheLowerEdgeAlone) {
  const Picture picture = overlaid({24, 1, 0.5});
  const auto untouched = picture.rgb.begin() + 960 * 490 * 3;
  EXPECT_TRUE(std::all_of(picture.rgb.begin(), untouched, [](float value) { return value == 0.5f; }));
  EXPECT_GT(pixel(picture, 2, 538)[0], 0.75f);
}

TEST_F(Overlay, ThePlayheadFollowsTimeAndLambda) {
  const Point at_third = playhead_of(overlaid({16, 16 / 24.0, 1.0 / 3}));
  const Point at_half = playhead_of(overlaid({24, 1, 0.5}));
  const Point at_end = playhead_of(overlaid({48, 2, 1}));
  EXPECT_GT(at_half.x, at_third.x + 20);
  EXPECT_LT(at_half.y, at_third.y - 1);
  EXPECT_NEAR(at_end.x - at_half.x, 3 * (at_half.x - at_third.x), 2);
  EXPECT_LT(at_end.x, 960);
}

TEST_F(Overlay, NumbersDoNotPushTheCurveAbout) {
  const Picture early = overlaid({8, 1.0 / 3, 1.0 / 6}), late = overlaid({48, 2, 1});
  const auto first_line = [](const Picture& picture) {  // where the strip's upper line begins
    int x = 1;
    while (x < 959 && pixel(picture, x, 508)[0] == pixel(picture, 0, 508)[0]) ++x;
    return x;
  };
  EXPECT_EQ(first_line(early), first_line(late));
  EXPECT_GT(first_line(late), 150);
  EXPECT_LT(first_line(late), 300);
}

TEST_F(Overlay, SmallPicturesAndOneFrameAreNoTrouble) {
  for (const int width : {1, 16, 100, 300}) {
    Picture picture = blank_picture(width, std::max(1, width / 2), grey);
    draw_overlay(picture, {{0, 0, 0.5}}, {0, 0, 0.5});
    draw_legend(picture, {"displacement", 0, 1, cold_to_hot});
    EXPECT_EQ(picture.width, width);
    EXPECT_TRUE(std::all_of(picture.rgb.begin(), picture.rgb.end(),
                            [](float value) { return value >= 0 && value <= 1; }));
  }
}

TEST_F(Overlay, ALegendShowsItsColoursFromLowToHigh) {
  Picture picture = blank_picture(960, 540, grey);
  draw_legend(picture, {"displacement", 0, 0.125, cold_to_hot});
  int first = 960, last = 0, row = 0;
  for (int y = 0; y < 540; ++y)
    for (int x = 0; x < 960; ++x) {
      const float* p = pixel(picture, x, y);
      if (p[1] != 0 || p[0] + p[2] < 0.99f) continue;  // of the bar: red and blue alone
      first = std::min(first, x);
      last = std::max(last, x);
      row = y;
    }
  ASSERT_GT(last, first + 100);
  EXPECT_GT(pixel(picture, first, row)[2], 0.98f);
  EXPECT_GT(pixel(picture, last, row)[0], 0.98f);
  EXPECT_NEAR(pixel(picture, (first + last) / 2, row)[0], 0.5f, 0.01f);
  EXPECT_GT(first, 480);
  EXPECT_LT(row, 270);
}

TEST_F(Overlay, LinesCoverPixelsByTheirShare) {
  Picture picture = blank_picture(20, 20, Rgb::Zero());
  const Point ends[2] = {{-5, 10}, {25, 10}};  // between two rows
  draw_line(picture, ends, 2, {{1, 1, 1}});
  EXPECT_FLOAT_EQ(pixel(picture, 10, 9)[0], 1);
  EXPECT_FLOAT_EQ(pixel(picture, 10, 10)[0], 1);
  EXPECT_FLOAT_EQ(pixel(picture, 10, 8)[0], 0);
  Picture thin = blank_picture(20, 20, Rgb::Zero());
  draw_line(thin, ends, 1, {{1, 1, 1}, 0.5f});
  EXPECT_FLOAT_EQ(pixel(thin, 10, 9)[0], 0.25f);
}

TEST_F(Overlay, TextIsAlignedAndKnowsGreek) {
  Picture picture = blank_picture(200, 40, Rgb::Zero());
  const int width = text_width("λ 0.42", 20);
  EXPECT_GT(width, 40);
  write_text(picture, 150, 30, "λ 0.42", {20, {1, 1, 1}, Align::right});
  int first = 200, last = 0;
  for (int i = 0; i < 200 * 40; ++i) {
    if (picture.rgb[static_cast<std::size_t>(i) * 3] < 0.3f) continue;
    first = std::min(first, i % 200);
    last = std::max(last, i % 200);
  }
  EXPECT_NEAR(last, 149, 3);
  EXPECT_NEAR(first, 150 - width, 3);
  EXPECT_NE(text_width("λ", 20), text_width("?", 20));
}

}  // namespace
}  // namespace flexkey
