#include "flexkey/preview/images/gif.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "flexkey/mesh/read_file.h"
#include "flexkey/preview/images/draw.h"
#include "flexkey/preview/images/srgb.h"
#include "preview_images/gif_file.h"
#include "preview_images/test_folder.h"

namespace flexkey {
namespace {

using test::GifFile;
using test::read_gif;

/// A blue square that moves to the right over ramps of colour.
Picture moving(int frame) {
  Picture picture = test::ramps(60, 40);
  fill(picture, {frame * 2, 10, 12, 12}, {colour_from_srgb(20, 40, 230)});
  return picture;
}

class Gif : public test::TestFolder {
 protected:
  GifFile written(int frames, double fps) const {
    GifWriter writer(folder() / "x.gif");
    for (int k = 0; k < frames; ++k) writer.add(moving(k), k / fps);
    writer.finish(frames / fps);
    return read_gif(folder() / "x.gif");
  }
};

std::vector<int> delays_of(const GifFile& gif) {
  std::vector<int> delays;
  for (const GifFile::Frame& frame : gif.frames) delays.push_back(frame.delay);
  return delays;
}

TEST_F(Gif, HasEveryFrameAndRepeatsForEver) {
  const GifFile gif = written(20, 10);
  EXPECT_EQ(gif.width, 60);
  EXPECT_EQ(gif.height, 40);
  EXPECT_EQ(gif.frames.size(), 20u);
  EXPECT_EQ(gif.repeats, 0);
  EXPECT_THAT(delays_of(gif), testing::Each(10));
}

TEST_F(Gif, DelaysAreWholeCentisecondsThatAddUpToTheClip) {
  const std::vector<int> delays = delays_of(written(24, 24));
  EXPECT_EQ(std::accumulate(delays.begin(), delays.end(), 0), 100);
  EXPECT_THAT(delays, testing::Each(testing::AnyOf(4, 5)));
}

TEST_F(Gif, LeavesOutFramesThatViewersWouldSlowDown) {
  const std::vector<int> delays = delays_of(written(120, 120));
  EXPECT_EQ(std::accumulate(delays.begin(), delays.end(), 0), 100);
  EXPECT_THAT(delays, testing::Each(testing::AllOf(testing::Ge(2), testing::Le(3))));
}

TEST_F(Gif, ShowsThePicturesItWasGiven) {
  const GifFile gif = written(6, 10);
  for (std::size_t k = 0; k < gif.frames.size(); ++k) {
    const std::vector<std::uint8_t> wanted = srgb_bytes(moving(static_cast<int>(k)));
    double squares = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) squares += std::pow(wanted[i] - gif.frames[k].rgb[i], 2);
    EXPECT_LT(std::sqrt(squares / static_cast<double>(wanted.size())), 8)
        << k;                                              // of 255, through 255 colours
    const std::size_t middle = (16 * 60 + 2 * k + 6) * 3;  // of the square
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(gif.frames[k].rgb[middle + c], wanted[middle + c], 6) << k;
  }
}

TEST_F(Gif, LaterFramesHoldOnlyWhatChanges) {
  const GifFile gif = written(3, 10);
  for (std::size_t k = 1; k < 3; ++k) {
    EXPECT_EQ(gif.frames[k].top, 10);
    EXPECT_EQ(gif.frames[k].height, 12);
    EXPECT_LE(gif.frames[k].width, 14);
  }
}

TEST_F(Gif, AStillClipKeepsItsFrames) {
  GifWriter writer(folder() / "x.gif");
  for (int k = 0; k < 5; ++k) writer.add(moving(0), k * 0.1);
  writer.finish(0.5);
  const GifFile gif = read_gif(folder() / "x.gif");
  EXPECT_THAT(delays_of(gif), testing::ElementsAre(10, 10, 10, 10, 10));
  EXPECT_EQ(gif.frames.back().rgb, gif.frames.front().rgb);
}

TEST_F(Gif, BrightnessThatCreepsIsFollowed) {
  GifWriter writer(folder() / "x.gif");
  for (int k = 0; k < 100; ++k) {
    const float light = linear_from_srgb(static_cast<float>(50 + k) / 255);
    writer.add(blank_picture(16, 16, {light, light, light}), k * 0.1);
  }
  writer.finish(10);
  EXPECT_NEAR(read_gif(folder() / "x.gif").frames.back().rgb[0], 149, 4);
}

TEST_F(Gif, HasTheSameBytesTwiceAndLeavesNothingElse) {
  written(5, 24);
  const std::string first = read_file(folder() / "x.gif");
  written(5, 24);
  EXPECT_EQ(read_file(folder() / "x.gif"), first);
  EXPECT_THAT(names(), testing::ElementsAre("x.gif"));
}

TEST_F(Gif, AnUnfinishedOneLeavesNothing) {
  {
    GifWriter writer(folder() / "x.gif");
    writer.add(moving(0), 0);
  }
  EXPECT_TRUE(names().empty());
}

}  // namespace
}  // namespace flexkey
