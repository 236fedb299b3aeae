#include "flexkey/html/write_page.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <system_error>

#include <unistd.h>

#include "flexkey/html/viewer.h"
#include "flexkey/mesh/error.h"
#include "flexkey/mesh/read_file.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

using nlohmann::json;

/// A cube that rises by one from its first frame to its second.
Clip rising_cube() {
  Clip clip;
  clip.name = "rise";
  clip.mesh = meshes::cube();
  clip.frames = {clip.mesh.positions, clip.mesh.positions.rowwise() + Eigen::RowVector3d(0, 1, 0)};
  clip.reports = {{.frame = 0}, {.frame = 1}};
  return clip;
}

/// A failure does not print the whole page.
bool has(const std::string& page, const std::string& text) {
  return page.find(text) != std::string::npos;
}

class WritePage : public testing::Test {
 protected:
  std::string written(const Clip& clip, const PageContents& contents) {
    const std::uintmax_t bytes = write_page(clip, contents, path_);
    EXPECT_EQ(bytes, std::filesystem::file_size(path_));
    return read_file(path_);
  }

  /// What lies in the page's block of this name.
  static std::string block(const std::string& page, const std::string& id) {
    const std::size_t begin = page.find('>', page.find("id=\"" + id + "\"")) + 1;
    return page.substr(begin, page.find('<', begin) - begin);
  }

  void TearDown() override { std::filesystem::remove(path_); }

  const std::filesystem::path path_ =
      std::filesystem::path(testing::TempDir()) / ("flexkey_page_" + std::to_string(getpid()) + ".html");
};

TEST_F(WritePage, HoldsTheGlbAndTheShot) {
  Positions start(1, 3), end(1, 3);
  start << 0.1, 0, 0;
  end << 0.1, 1, 0;
  const std::string page = written(
      rising_cube(),
      {"glTF!", {{"tip", false, {start, end}}, {"base", true, {start, Positions(0, 3)}}}, {{"walk", 0.5}}});
  EXPECT_EQ(block(page, "glb"), "Z2xURiE=");
  const json shot = json::parse(block(page, "shot"));
  EXPECT_EQ(shot["name"], "rise");
  EXPECT_EQ(shot["bounds"], json::parse(R"({"min": [0, 0, 0], "max": [1, 2, 1]})"));
  EXPECT_EQ(shot["starts"], json::parse(R"({"walk": 0.5})"));
  EXPECT_EQ(shot["handles"][0], json::parse(R"({"name": "tip", "anchor": false, "points": 1,
                                                "positions": [[0.1, 0, 0], [0.1, 1, 0]]})"));
  EXPECT_EQ(shot["handles"][1]["positions"][1], json()) << "it does not hold";
  EXPECT_TRUE(has(page, "[[0.1,0.0,0.0]")) << "as short as floats can be";
}

TEST_F(WritePage, NamesCannotEndTheirBlock) {
  Clip clip = rising_cube();
  clip.name = "</script><script>alert(1)<!--";
  const std::string page = written(clip, {"", {{"<img src=x>", false, {}}}, {{"]]>", 0}}});
  EXPECT_FALSE(has(page, "alert(1)<"));
  EXPECT_FALSE(has(page, "<img"));
  const json shot = json::parse(block(page, "shot"));
  EXPECT_EQ(shot["name"], clip.name);
  EXPECT_EQ(shot["handles"][0]["name"], "<img src=x>");
}

TEST_F(WritePage, NamesThatLookLikeItsPlacesAreNames) {
  Clip clip = rising_cube();
  clip.name = "@glb@ @shot@";
  const std::string page = written(clip, {"glTF!", {}, {}});
  EXPECT_EQ(json::parse(block(page, "shot"))["name"], clip.name);
  EXPECT_EQ(block(page, "glb"), "Z2xURiE=");
}

TEST_F(WritePage, NamesThatAreNoUtf8AreReplaced) {
  Clip clip = rising_cube();
  clip.name = "a\xFF";
  EXPECT_EQ(json::parse(block(written(clip, {"", {}, {}}), "shot"))["name"], "a\uFFFD");
}

TEST_F(WritePage, IsSelfContainedAndUnderAMegabyteBesideItsGlb) {
  const std::string page = written(rising_cube(), {"", {}, {}});
  EXPECT_LT(page.size(), 1'000'000u);
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_TRUE(has(page, "default-src 'none'"));
  for (const char* reference : {"<link", "<iframe", " src=\"", "@import"})
    EXPECT_FALSE(has(page, reference)) << reference;
}

TEST_F(WritePage, KeepsTheLicenceOfWhatItContains) {
  const std::string page = written(rising_cube(), {"", {}, {}});
  EXPECT_TRUE(has(page, "copyright 2010-2026 three.js authors"));
  EXPECT_TRUE(has(page, "The above copyright notice and this permission notice shall be included"));
}

TEST_F(WritePage, AFullDiskIsAnError) {
  EXPECT_THROW(write_page(rising_cube(), {"", {}, {}}, "/dev/full"), OutputError);
}

TEST(Viewer, HasEachPlaceOnce) {
  for (const std::string_view place : {"@shot@", "@glb@"}) {
    const std::size_t first = viewer_page().find(place);
    ASSERT_NE(first, std::string_view::npos);
    EXPECT_EQ(viewer_page().find(place, first + 1), std::string_view::npos) << place;
  }
}

}  // namespace
}  // namespace flexkey
