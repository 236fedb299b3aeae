// The picture of a shot that `check --picture` draws.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/work_folder.h"
#include "flexkey/mesh/read_file.h"
#include "flexkey/preview/images/image_file.h"
#include "flexkey/preview/images/labels.h"

namespace flexkey::test {
namespace {

using testing::HasSubstr;

const float* pixel(const Picture& picture, int x, int y) {
  return &picture.rgb[static_cast<std::size_t>(y * picture.width + x) * 3];
}

/// Pixels in which one channel is clearly above the two others.
int count_of(const Picture& picture, int channel) {
  int count = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const float* rgb = pixel(picture, x, y);
      if (rgb[channel] > 1.6f * std::max(rgb[(channel + 1) % 3], rgb[(channel + 2) % 3])) ++count;
    }
  return count;
}

class CheckPicture : public WorkFolder {
 protected:
  void SetUp() override {
    WorkFolder::SetUp();
    setenv("FLEXKEY_MODULES", std::filesystem::path(FLEXKEY_PROGRAM).parent_path().c_str(), 1);
  }
  Picture picture_of(const std::string& shot) const {
    write("shot.yaml", shot);
    const ProgramResult result = run({"check", "shot.yaml", "--picture", "out/shot.png"});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.output, HasSubstr("picture  ./out/shot.png"));
    return read_picture(folder() / "out/shot.png");
  }
};

TEST_F(CheckPicture, HasBlueHandlesRedAnchorsAndGreenPaths) {
  const std::string mesh = "mesh: bar.obj\nhandles:\n", base = "  base: {select: {axis: z, below: 1%}}\n";
  const std::string select = "  tip: {select: {axis: z, above: 99%}, move: {keys: {0s: [0, 0, 0], 1s: ";
  const Picture moving = picture_of(mesh + base + select + "[9, 0, 0]}}}\n");
  EXPECT_GT(count_of(moving, 2), 100);
  EXPECT_GT(count_of(moving, 0), 100);
  EXPECT_GT(count_of(moving, 1), 100);
  const Picture held = picture_of(mesh + base);
  EXPECT_GT(count_of(held, 0), 100);
  EXPECT_EQ(count_of(held, 1), 0);
  EXPECT_EQ(count_of(held, 2), 0);
}

TEST_F(CheckPicture, TintsTheRegionOfInterest) {
  const auto tinted = [](const Picture& picture) {
    int count = 0;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x)
        if (pixel(picture, x, y)[0] > 2 * pixel(picture, x, y)[2]) ++count;
    return count;
  };
  const std::string shot = "mesh: bar.obj\nhandles: {tip: {select: {nearest: [0, 0, 12]}}}\n";
  const int without = tinted(picture_of(shot));
  EXPECT_GT(tinted(picture_of(shot + "roi: {axis: z, above: 50%}\n")), without + 1000);
}

TEST_F(CheckPicture, IsNotDrawnOverAnInputNorOfAnUnknownKind) {
  write("shot.yaml", minimal_shot);
  const ProgramResult unknown = run({"check", "shot.yaml", "--picture", "shot.xyz"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.errors, HasSubstr("--picture './shot.xyz'"));
  write("map.png", "");
  write("bar.mtl", "newmtl skin\nmap_Kd map.png\n");
  write("bar.obj", "mtllib bar.mtl\nusemtl skin\n" + obj_text(meshes::bar(1, 1, 2)));
  EXPECT_THAT(run({"check", "shot.yaml", "--picture", "map.png"}).errors,
              HasSubstr("would replace an input"));
  EXPECT_EQ(read_file(folder() / "map.png"), "");
  write("shot.yaml", "mesh: none.obj\n");
  EXPECT_NE(run({"check", "shot.yaml", "--picture", "shot.png"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder() / "shot.png"));
}

TEST_F(CheckPicture, LabelsOfOnePlaceStandUnderEachOther) {
  for (const int count : {1, 5, 20}) {
    Picture picture = blank_picture(400, 300, Rgb(0.5f, 0.5f, 0.5f));
    const Rgb green(0, 1, 0);
    draw_labels(picture, std::vector<Label>(static_cast<std::size_t>(count), {"name", {150, 290}, green}));
    int most = 0;
    for (int x = 0; x < 60; ++x) {  // one of these columns is that of the labels' bars
      int runs = 0;
      for (int y = 1; y < picture.height; ++y) {
        const bool is_bar = pixel(picture, x, y)[1] == 1 && pixel(picture, x, y)[0] == 0;
        const bool was_bar = pixel(picture, x, y - 1)[1] == 1 && pixel(picture, x, y - 1)[0] == 0;
        if (is_bar && !was_bar) ++runs;
      }
      most = std::max(most, runs);
    }
    EXPECT_EQ(most, count);
  }
}

}  // namespace
}  // namespace flexkey::test
