// output.preview: its keys, their defaults, and what is wrong with them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "timeline/parsing.h"

namespace flexkey {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double degree = std::numbers::pi / 180;

/// A shot of two seconds whose preview stands in line 5 from column 19.
std::string with_preview(const std::string& preview, const std::string& more = {}) {
  return with_base("duration: 2s\noutput: {preview: " + preview + "}\n" + more);
}

PreviewOutput preview_of(const std::string& preview) {
  return parse(with_preview(preview)).preview;
}

std::string errors_of_preview(const std::string& preview) {
  return errors_of(with_preview(preview));
}

TEST(PreviewOutputs, HaveADefaultForEverything) {
  const PreviewOutput preview = preview_of("{}");
  EXPECT_EQ(preview.dir, "<shot>/");
  EXPECT_EQ(preview.width, 960);
  EXPECT_EQ(preview.height, 540);
  EXPECT_EQ(preview.samples, 8);
  EXPECT_EQ(preview.subdivide, 2);
  EXPECT_THAT(preview.frames, IsEmpty());
  EXPECT_EQ(preview.format, PreviewOutput::Format::png);
  EXPECT_EQ(preview.camera.fit, PreviewCamera::Fit::clip);
  EXPECT_FALSE(preview.camera.look_at);
  EXPECT_EQ(preview.style, PreviewOutput::Style::clay);
  EXPECT_EQ(preview.quality, PreviewOutput::Quality::final);
  EXPECT_EQ(preview.handles, PreviewOutput::Handles::none);
  EXPECT_FALSE(preview.overlay);
  EXPECT_EQ(preview.gif.path, "");
  EXPECT_EQ(preview.sheet.path, "");
  EXPECT_EQ(parse(with_base("output: a.glb\n")).preview.dir, "") << "no pictures unless asked for";
}

TEST(PreviewOutputs, AreAFolderOrAMapping) {
  EXPECT_EQ(preview_of("pictures/").dir, "pictures/");
  EXPECT_EQ(preview_of("{dir: pictures}").dir, "pictures");
  EXPECT_EQ(errors_of_preview("[a]"), "shot.yaml:5:19: error: 'preview' is a path, not a list");
}

TEST(PreviewOutputs, TakeEveryKey) {
  const PreviewOutput preview = preview_of(
      "{size: [64, 48], samples: 4, subdivide: 0, frames: [0-10x5, 47], format: webp, turntable: -0.5, "
      "style: "
      "error, quality: draft, handles: true, overlay: on, gif: {path: a.gif, width: 32}, contact_sheet: "
      "{path: "
      "b.jpg, at: [0.5s, 36f], width: 16}, camera: {look_at: [1, 2, 3], azimuth: 90deg, elevation: -5deg, "
      "fov: "
      "1rad, zoom: 2, fit: rest, up: z}}");
  EXPECT_EQ(preview.width, 64);
  EXPECT_EQ(preview.height, 48);
  EXPECT_EQ(preview.samples, 4);
  EXPECT_EQ(preview.subdivide, 0);
  EXPECT_THAT(frames_in(preview.frames), ElementsAre(0, 5, 10, 47));
  EXPECT_EQ(preview.format, PreviewOutput::Format::webp);
  EXPECT_EQ(preview.turntable, -0.5);
  EXPECT_EQ(preview.style, PreviewOutput::Style::error);
  EXPECT_EQ(preview.quality, PreviewOutput::Quality::draft);
  EXPECT_EQ(preview.handles, PreviewOutput::Handles::all);
  EXPECT_TRUE(preview.overlay);
  EXPECT_EQ(preview_of("{handles: borders}").handles, PreviewOutput::Handles::borders);
  EXPECT_EQ(preview.gif.path, "a.gif");
  EXPECT_EQ(preview.gif.width, 32);
  EXPECT_EQ(preview.sheet.path, "b.jpg");
  EXPECT_EQ(preview.sheet.width, 16);
  ASSERT_EQ(preview.sheet.at.size(), 2u);
  EXPECT_EQ(preview.sheet.at[1].time, 1.5);
  EXPECT_EQ(preview.camera.look_at, Vec3(1, 2, 3));
  EXPECT_DOUBLE_EQ(preview.camera.azimuth, 90 * degree);
  EXPECT_DOUBLE_EQ(preview.camera.elevation, -5 * degree);
  EXPECT_EQ(preview.camera.fov, 1);
  EXPECT_EQ(preview.camera.zoom, 2);
  EXPECT_EQ(preview.camera.fit, PreviewCamera::Fit::rest);
  EXPECT_EQ(preview.camera.up, UpAxis::z);
}

TEST(PreviewOutputs, MisspeltKeysAndWordsAreAnsweredWithTheNearest) {
  EXPECT_EQ(errors_of_preview("{sise: [1, 1]}"),
            "shot.yaml:5:20: error: unknown key 'sise' in 'preview'; did you mean 'size'?");
  EXPECT_EQ(errors_of_preview("{camera: {azimut: 3deg}}"),
            "shot.yaml:5:29: error: unknown key 'azimut' in 'camera'; did you mean 'azimuth'?");
  EXPECT_EQ(errors_of_preview("{style: clai}"),
            "shot.yaml:5:27: error: unknown style 'clai'; did you mean 'clay'?");
  EXPECT_EQ(errors_of_preview("{format: bmp}"),
            "shot.yaml:5:28: error: unknown format 'bmp'; known are png, exr, webp, jpg, jpeg");
  EXPECT_EQ(errors_of_preview("{gif: {pth: a.gif}}"),
            "shot.yaml:5:26: error: unknown key 'pth' in 'gif'; did you mean 'path'?");
}

TEST(PreviewOutputs, NumbersHaveBounds) {
  EXPECT_EQ(errors_of_preview("{size: [0, 10]}"), "shot.yaml:5:27: error: width 0 is outside 1..16384");
  EXPECT_EQ(errors_of_preview("{size: [100000, 100000]}"),
            "shot.yaml:5:27: error: width 100000 is outside 1..16384\n"
            "shot.yaml:5:35: error: height 100000 is outside 1..16384");
  EXPECT_EQ(errors_of_preview("{size: [16384, 16384]}"),
            "shot.yaml:5:26: error: a picture of 16384 x 16384 pixels is too large: at most 36 million");
  EXPECT_EQ(errors_of_preview("{size: [1, 16384]}"), "");
  EXPECT_EQ(errors_of_preview("{size: [1, 16384], format: webp}"),
            "shot.yaml:5:46: error: a WebP has at most 16383 pixels a side");
  EXPECT_EQ(errors_of_preview("{size: 960}"),
            "shot.yaml:5:26: error: size is [width, height] in pixels, such as [960, 540], not '960'");
  EXPECT_EQ(errors_of_preview("{samples: 0}"), "shot.yaml:5:29: error: samples 0 is outside 1..4096");
  EXPECT_EQ(errors_of_preview("{subdivide: 5}"), "shot.yaml:5:31: error: subdivide 5 is outside 0..4");
  EXPECT_EQ(errors_of_preview("{camera: {fov: 180deg}}"),
            "shot.yaml:5:34: error: fov 180deg is outside 0.1deg..170deg");
  EXPECT_EQ(errors_of_preview("{camera: {elevation: 91deg}}"),
            "shot.yaml:5:40: error: elevation 91deg is outside -90deg..90deg");
  EXPECT_EQ(errors_of_preview("{camera: {zoom: 0}}"), "shot.yaml:5:35: error: zoom 0 is outside 0.001..1000");
  EXPECT_THAT(errors_of_preview("{turntable: 1e9}"), HasSubstr("5:31: error: turntable 1e9 is outside"));
}

TEST(PreviewOutputs, FramesAreRangesWithinTheShot) {
  EXPECT_THAT(frames_in(preview_of("{frames: '0-2, 7,4-8x4'}").frames), ElementsAre(0, 1, 2, 4, 7, 8));
  EXPECT_THAT(frames_in(preview_of("{frames: 48}").frames), ElementsAre(48));
  EXPECT_THAT(frames_in(preview_of("{frames: [0-4x2, 47-60]}").frames), ElementsAre(0, 2, 4, 47, 48));
  EXPECT_THAT(
      warnings_of(with_preview("{frames: [0-4, 40-49, 60]}")),
      ElementsAre("shot.yaml:5:34: warning: frame 49 is past the shot's last frame, 48, and is left out",
                  "shot.yaml:5:41: warning: frame 60 is past the shot's last frame, 48, and is left out"));
  EXPECT_EQ(errors_of_preview("{frames: [60-70]}"),
            "shot.yaml:5:29: error: no frame of these is within the shot, whose last frame is 48");
  for (const char* wrong : {"3-1", "a", "1-2x0", "-3", "''", "'1,'", "[[1]]"})
    EXPECT_THAT(errors_of_preview("{frames: " + std::string(wrong) + "}"),
                HasSubstr("is not a frame, a range 0-30 or a stepped range 60-90x2"))
        << wrong;
}

TEST(PreviewOutputs, FilesNameTheirKind) {
  EXPECT_EQ(errors_of_preview("{gif: a.png}"),
            "shot.yaml:5:25: error: 'gif' names a file that ends in '.gif', not 'a.png'");
  EXPECT_EQ(errors_of_preview("{gif: {width: 3}}"), "shot.yaml:5:25: error: 'gif' needs 'path'");
  EXPECT_THAT(errors_of_preview("{contact_sheet: a.bmp}"), HasSubstr("ends in '.png' or '.exr' or '.webp'"));
  EXPECT_EQ(preview_of("{contact_sheet: {at: [1s]}}").sheet.path, "<shot>.png");
  EXPECT_THAT(warnings_of(with_preview("{contact_sheet: {at: [1s, 3s]}}")),
              ElementsAre("shot.yaml:5:45: warning: 3s is past the shot's end, 2s, and is left out"));
}

TEST(PreviewOutputs, OfASweepNeedAFolderEach) {
  const std::string sweep = "sweep: {lambda: [0, 1]}\n";
  const std::vector<Shot> runs = runs_of(with_preview("{contact_sheet: a.png, gif: a_<lambda>.gif}", sweep));
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[1].preview.dir, "shot_1/");
  EXPECT_EQ(runs[1].preview.gif.path, "a_1.gif");
  EXPECT_EQ(runs[0].preview.sheet.path, "a.png");
  EXPECT_EQ(runs[1].preview.sheet.path, "a.png") << "one sheet over all";
  EXPECT_EQ(
      errors_of(with_preview("{dir: a/, gif: a.gif}", sweep)),
      "shot.yaml:5:25: error: output path 'a/' does not name the swept key; write '<lambda>' into it\n"
      "shot.yaml:5:34: error: output path 'a.gif' does not name the swept key; write '<lambda>' into it");
}

TEST(PreviewOutputs, ExpandTheirPlaceholders) {
  const std::vector<Shot> runs =
      runs_of(with_preview("{dir: <shot>/p, gif: <shot>.gif, contact_sheet: <lambda>.png}"));
  EXPECT_EQ(runs[0].preview.dir, "shot/p");
  EXPECT_EQ(runs[0].preview.gif.path, "shot.gif");
  EXPECT_EQ(runs[0].preview.sheet.path, "0.5.png");
  EXPECT_THAT(errors_of_preview("{dir: <shut>/}"), HasSubstr("unknown placeholder '<shut>'"));
  EXPECT_THAT(errors_of(with_preview("{contact_sheet: <lambda>.png}", "lambda: {0s: 0, 1s: 1}\n")),
              HasSubstr("'<lambda>' in output path '<lambda>.png' has no one value"));
}

}  // namespace
}  // namespace flexkey
