#include "flexkey/preview/images/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "flexkey/mesh/read_file.h"
#include "flexkey/preview/images/srgb.h"
#include "preview_images/test_folder.h"

namespace flexkey {
namespace {

using test::ramps;

/// A file of one format, by its extension.
class ImageFile : public test::TestFolder, public testing::WithParamInterface<const char*> {
 protected:
  std::filesystem::path path() const { return folder() / (std::string("x.") + GetParam()); }
};

/// The largest difference of two pictures of one size, in sRGB values of 255.
int largest_difference(const Picture& a, const Picture& b) {
  const std::vector<std::uint8_t> left = srgb_bytes(a), right = srgb_bytes(b);
  int largest = left.size() == right.size() ? 0 : 255;
  for (std::size_t i = 0; i < std::min(left.size(), right.size()); ++i)
    largest = std::max(largest, std::abs(left[i] - right[i]));
  return largest;
}

TEST_P(ImageFile, IsReadBackWithItsSizeAndPixels) {
  const Picture picture = ramps(48, 32);
  write_picture(picture, path());
  const Picture read = read_picture(path());
  EXPECT_EQ(read.width, 48);
  EXPECT_EQ(read.height, 32);
  const std::map<std::string, int> tolerance{{"png", 0}, {"exr", 1}, {"webp", 24}, {"jpg", 24}};
  EXPECT_LE(largest_difference(read, picture), tolerance.at(GetParam()));
}

TEST_P(ImageFile, SaysWhatItWasMadeFrom) {
  const PictureTags tags{"6af1c09e", 12, 0.5, 0.25};
  write_picture(ramps(16, 8), path(), tags);
  const std::optional<PictureTags> read = read_tags(path());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->inputs, tags.inputs);
  EXPECT_EQ(read->frame, 12);
  EXPECT_EQ(read->time, 0.5);
  EXPECT_EQ(read->lambda, 0.25);
  EXPECT_TRUE(was_made_from(path(), "6af1c09e"));
  EXPECT_FALSE(was_made_from(path(), "6af1c09f"));
}

TEST_P(ImageFile, HasTheSameBytesTwice) {
  write_picture(ramps(40, 30), path(), {"abc", 1, 2, 1});
  const std::string first = read_file(path());
  write_picture(ramps(40, 30), path(), {"abc", 1, 2, 1});
  EXPECT_EQ(read_file(path()), first);
  EXPECT_THAT(names(), testing::ElementsAre(path().filename().string()));
}

INSTANTIATE_TEST_SUITE_P(Formats, ImageFile, testing::Values("png", "exr", "webp", "jpg"),
                         [](const auto& format) { return std::string(format.param); });

using ImageFiles = test::TestFolder;

TEST_F(ImageFiles, ExrKeepsLightBeyondWhite) {
  write_picture({2, 1, {4, 0.001f, 0, 100, 1.0f / 3, 0.5f}}, folder() / "x.exr");
  const Picture read = read_picture(folder() / "x.exr");
  EXPECT_EQ(read.rgb[0], 4);
  EXPECT_EQ(read.rgb[3], 100);
  EXPECT_NEAR(read.rgb[1], 0.001, 0.001 / 2048);
  EXPECT_NEAR(read.rgb[4], 1.0 / 3, 1.0 / 2048);
}

TEST_F(ImageFiles, WhatIsNoFrameOfOursWasMadeFromNothing) {
  EXPECT_FALSE(was_made_from(folder() / "none.png", "abc"));
  EXPECT_FALSE(was_made_from(folder(), "abc"));
  std::ofstream(folder() / "text.png") << "not a picture";
  EXPECT_FALSE(was_made_from(folder() / "text.png", "abc"));
  write_picture(ramps(8, 8), folder() / "whole.png", {"abc", 0, 0, 0});
  const std::string whole = read_file(folder() / "whole.png");
  std::ofstream(folder() / "half.png") << whole.substr(0, 30);
  EXPECT_FALSE(was_made_from(folder() / "half.png", "abc"));
}

TEST_F(ImageFiles, ATagLineIsReadAsItWasWrittenOrNotAtAll) {
  const std::string line = describe({"6af1", 3, 0.125, 1});
  EXPECT_EQ(line, "flexkey inputs=6af1 frame=3 time=0.125 lambda=1");
  EXPECT_TRUE(parse_tags(line));
  for (const char* other : {"", "flexkey", "a holiday", "flexkey inputs=6af1 frame=x time=0 lambda=0",
                            "flexkey inputs=6af1 frame=3 time=0.1"})
    EXPECT_FALSE(parse_tags(other)) << other;
}

TEST_F(ImageFiles, MissingFoldersAreMade) {
  write_picture(ramps(8, 8), folder() / "a" / "b" / "x.png");
  EXPECT_EQ(read_picture(folder() / "a" / "b" / "x.png").width, 8);
}

}  // namespace
}  // namespace flexkey
