#include "cli/html_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/work_folder.h"
#include "flexkey/animate/animate.h"
#include "flexkey/html/base64.h"
#include "flexkey/mesh/read_file.h"
#include "flexkey/timeline/parse.h"

namespace flexkey {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::ProgramResult;
using testing::HasSubstr;

class HtmlPage : public test::WorkFolder {
 protected:
  /// The minimal shot with this output.
  ProgramResult animate(const std::string& output, const std::vector<std::string>& more = {}) {
    write("shot.yaml", test::minimal_shot);
    std::vector<std::string> arguments{"animate", "shot.yaml", "--set", "output=" + output};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  /// Whether the file has this text; a failure does not print all of it.
  bool holds(const std::string& file, const std::string& text) const {
    return read_file(folder() / file).find(text) != std::string::npos;
  }
};

TEST_F(HtmlPage, HoldsTheGlbThatIsWrittenBesideIt) {
  const ProgramResult result = animate("{gltf: bar.glb, html: pages/bar.html}");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.output, "./bar.glb\n./pages/bar.html\n");
  EXPECT_TRUE(holds("pages/bar.html", ">" + base64(read_file(folder() / "bar.glb")) + "<"));
}

TEST_F(HtmlPage, AloneHoldsAWebGlb) {
  const ProgramResult result = animate("{html: bar.html}", {"--json", "-q"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_FALSE(fs::exists(folder() / "bar.glb"));
  const json page = json::parse(result.output)["runs"][0]["outputs"][0];
  EXPECT_EQ(page["path"], "./bar.html");
  EXPECT_EQ(page["bytes"], fs::file_size(folder() / "bar.html"));
  EXPECT_EQ(page["profile"], "web");
  EXPECT_LE(page["error"], 1e-3);
  EXPECT_TRUE(holds("bar.html", ">Z2xURg"));  // "glTF"
}

TEST_F(HtmlPage, IsTheSameForTheSameInput) {
  animate("{html: bar.html}", {"--threads", "1", "-d", "a"});
  animate("{html: bar.html}", {"--threads", "2", "-d", "b"});
  EXPECT_TRUE(read_file(folder() / "a/bar.html") == read_file(folder() / "b/bar.html"));
}

TEST_F(HtmlPage, OfASweepIsOneARun) {
  const ProgramResult result =
      animate("{html: bar_<lambda>.html}", {"--set", "sweep={lambda: [0, 1]}", "--frames", "0-5"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.output, "./bar_0.html\n./bar_1.html\n");
}

TEST_F(HtmlPage, IsRefusedUnderAnotherNameOrOverAnInput) {
  EXPECT_THAT(animate("{html: bar.htm}").errors,
              HasSubstr("the output './bar.htm' is a page and must end in '.html'"));
  write("shot.html", test::minimal_shot);
  const ProgramResult over = run({"animate", "shot.html", "--set", "output={html: shot.html}"});
  EXPECT_EQ(over.exit_code, 2);
  EXPECT_THAT(over.errors, HasSubstr("would replace an input"));
  EXPECT_EQ(run({"check", "shot.html", "--set", "output={html: shot.html}"}).exit_code, 2);
}

TEST_F(HtmlPage, IsListedByCheck) {
  write("shot.yaml", test::minimal_shot);
  const ProgramResult result =
      run({"check", "shot.yaml", "--json", "--set", "output={gltf: a.glb, html: {path: <shot>.html}}"});
  EXPECT_EQ(json::parse(result.output)["outputs"], json::array({"a.glb", "shot.html"}));
}

TEST_F(HtmlPage, OnAFullDiskIsAnErrorOfItsOwnCode) {
  const ProgramResult result = animate("{html: /dev/full}");
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_THAT(result.errors, HasSubstr("/dev/full"));
}

TEST_F(HtmlPage, UnderAFolderThatCannotBeIsRefusedBeforeTheSolve) {
  const ProgramResult result = animate("{html: bar.obj/page.html}");
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_EQ(result.errors.find("Progress: 100%"), std::string::npos);
}

TEST(PageHandles, AreInTheMiddleOfWhatTheHandlesLeadWhileTheyHold) {
  const Mesh mesh = meshes::bar(3, 3, 12);
  const Shot shot = parse_shot(R"(
mesh: bar.obj
fps: 4
handles:
  base: {select: {axis: z, below: 1%}}
  tip: {select: {axis: z, above: 99%}, move: {keys: {0s: [0, 0, 0], 1s: [2, 0, 0]}}}
  late: {select: {axis: z, above: 49%, below: 51%}, active: [0.5s, 2s]}
)",
                               "shot.yaml")
                        .shot;
  const Scene scene = bind_shot(shot, mesh);
  const Clip clip = animate(shot, mesh, scene);
  const std::vector<PageHandle> handles = cli::page_handles({shot, scene, clip});
  ASSERT_EQ(handles.size(), 3u);
  EXPECT_EQ(handles[0].name, "base");
  EXPECT_TRUE(handles[0].is_anchor);
  EXPECT_FALSE(handles[1].is_anchor);
  ASSERT_EQ(handles[1].points.size(), 5u) << "one a frame";
  EXPECT_TRUE(handles[1].points[0].isApprox(Positions(Eigen::RowVector3d(1.5, 1.5, 12)), 1e-12));
  EXPECT_TRUE(handles[1].points[2].isApprox(Positions(Eigen::RowVector3d(2.5, 1.5, 12)), 1e-12));
  EXPECT_EQ(handles[2].points[1].rows(), 0) << "it does not hold yet";
  EXPECT_EQ(handles[2].points[2].rows(), 1);
}

TEST(PageHandles, OfACurveLieAlongItsChain) {
  const Mesh mesh = meshes::grid(30, 4);
  const Shot shot = parse_shot(R"(
mesh: grid.obj
handles:
  edge: {select: {axis: y, above: 99%}}
  rim:
    select: {path: [[0, 0, 0], [30, 0, 0]]}
    curve: {keys: {0s: rest, 1s: {polyline: [[0, 0, 3], [30, 0, 3]]}}}
)",
                               "shot.yaml")
                        .shot;
  const Scene scene = bind_shot(shot, mesh);
  const Clip clip = animate(shot, mesh, scene);
  const std::vector<PageHandle> handles = cli::page_handles({shot, scene, clip});
  const Positions &first = handles[1].points.front(), &last = handles[1].points.back();
  ASSERT_EQ(first.rows(), 12) << "not all 31";
  EXPECT_TRUE(first.row(0).isZero());
  EXPECT_TRUE(first.row(11).isApprox(Eigen::RowVector3d(30, 0, 0)));
  EXPECT_TRUE(last.row(11).isApprox(Eigen::RowVector3d(30, 0, 3)));
}

}  // namespace
}  // namespace flexkey
