#include "flexkey/preview/images/sequence.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <vector>

namespace flexkey {
namespace {

constexpr const char* rest = "-vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2' -c:v libx264 -crf 18 -pix_fmt yuv420p";

std::string line(const PictureSequence& sequence, std::vector<int> frames, double fps) {
  std::string text = ffmpeg_line(sequence, frames, fps);
  const std::size_t at = text.find(rest);
  EXPECT_NE(at, std::string::npos) << text;
  return at == std::string::npos ? text : text.replace(at, std::string(rest).size(), "…");
}

TEST(Sequence, FramesAreNamedByFourDigitsAtLeast) {
  EXPECT_EQ(frame_path({"nose"}, 0), "nose/0000.png");
  EXPECT_EQ(frame_path({"nose/", ImageFormat::exr}, 120), "nose/0120.exr");
  EXPECT_EQ(frame_path({"nose", ImageFormat::jpg}, 12345), "nose/12345.jpg");
}

TEST(Sequence, FfmpegTakesFramesThatFollowEachOther) {
  EXPECT_EQ(line({"out/nose/"}, {0, 1, 2}, 24), "ffmpeg -framerate 24 -i out/nose/%04d.png … out/nose.mp4");
  EXPECT_EQ(line({"nose", ImageFormat::webp}, {12, 13}, 29.97),
            "ffmpeg -framerate 29.97 -start_number 12 -i nose/%04d.webp … nose.mp4");
}

TEST(Sequence, FfmpegTakesAllFilesWhereFramesAreLeftOut) {
  EXPECT_EQ(line({"nose"}, {0, 2, 4}, 24),
            "ffmpeg -framerate 12 -pattern_type glob -i 'nose/*.png' … nose.mp4");
  EXPECT_EQ(line({"nose"}, {0, 2, 5}, 24),
            "ffmpeg -framerate 24 -pattern_type glob -i 'nose/*.png' … nose.mp4");
}

TEST(Sequence, FfmpegEncodesLinearLight) {
  EXPECT_EQ(line({"nose", ImageFormat::exr}, {0, 1}, 24),
            "ffmpeg -framerate 24 -apply_trc iec61966_2_1 -i nose/%04d.exr … nose.mp4");
}

TEST(Sequence, NamesAreQuotedForTheShellAndForFfmpeg) {
  EXPECT_EQ(line({"my nose's 50%"}, {0, 1}, 24),
            R"(ffmpeg -framerate 24 -i 'my nose'\''s 50%%/%04d.png' … 'my nose'\''s 50%.mp4')");
}

}  // namespace
}  // namespace flexkey
