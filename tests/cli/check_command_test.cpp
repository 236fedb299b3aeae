#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/work_folder.h"

namespace flexkey {
namespace {

using nlohmann::json;
using test::ProgramResult;
using testing::HasSubstr;

class Check : public test::WorkFolder {};

TEST_F(Check, PrintsTheVertexCountOfEveryHandle) {
  write("shot.yaml", test::minimal_shot);
  const ProgramResult result = run({"check", "shot.yaml", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json report = json::parse(result.output);
  ASSERT_EQ(report["handles"].size(), 2u);
  EXPECT_EQ(report["handles"][0]["name"], "base");
  EXPECT_EQ(report["handles"][0]["vertices"], 16);
  EXPECT_EQ(report["handles"][0]["anchor"], true);
  EXPECT_EQ(report["handles"][1]["motions"], json::array({"rotate"}));
  EXPECT_EQ(report["frames"], 25);
  EXPECT_EQ(report["mesh"]["components"], 1);
  EXPECT_EQ(report["outputs"], json::array({"bar.glb"}));
}

TEST_F(Check, SaysOfEachHandleHowFarItGoesAndWhen) {
  write("shot.yaml",
        "mesh: bar.obj\nrigid: {middle: {box: {min: [0, 0, 5], max: [3, 3, 6]}}}\nhandles:\n"
        "  base: {select: {axis: z, below: 1%}}\n"
        "  tip: {select: {axis: z, above: 99%}, weight: 0.5, active: [0s, 0.5s],"
        " move: {keys: {0s: [0, 0, 0], 0.5s: [0, 3, 4], 1s: [0, 0, 0]}}}\n");
  const json report = json::parse(run({"check", "shot.yaml", "--json"}).output);
  EXPECT_EQ(report["handles"][0]["reach"], 0);
  EXPECT_NEAR(report["handles"][1]["reach"].get<double>(), 5, 1e-9);
  EXPECT_EQ(report["handles"][1]["weight"], 0.5);
  EXPECT_EQ(report["handles"][1]["active"], json::parse("[[0, 0.5]]"));
  EXPECT_EQ(report["rigid"], json::parse(R"([{"name": "middle", "vertices": 24}])"));
  const std::string table = run({"check", "shot.yaml"}).output;
  EXPECT_THAT(table, HasSubstr("5 (39.3 %)"));
  EXPECT_THAT(table, HasSubstr("move; soft 0.5, from 0 s to 0.5 s"));
  EXPECT_THAT(table, HasSubstr("rigid    middle: 24 vertices"));
}

TEST_F(Check, ReadsATimelineFromStandardInputAndWritesNothing) {
  const ProgramResult result = run({"check", "-"}, test::minimal_shot);
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("handle   tip"));
  EXPECT_FALSE(std::filesystem::exists(folder() / "bar.glb"));
}

TEST_F(Check, CountsBothSidesOfASeamAsTheFileDoes) {
  write("shot.yaml", "mesh: two.obj\nhandles: {all: {select: {nearest: [1, 0, 0]}}}\n");
  write("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\nf 4 5 6\n");
  const json report = json::parse(run({"check", "shot.yaml", "--json"}).output);
  EXPECT_EQ(report["handles"][0]["vertices"], 2);
  EXPECT_EQ(report["mesh"]["surface_vertices"], 5);
}

TEST_F(Check, ASelectionThatFailsIsBlamedOnItsPlace) {
  write("shot.yaml", test::minimal_shot);
  const ProgramResult result = run({"check", "shot.yaml", "--set", "handles.tip.select={group: nose}"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("--set handles.tip.select: error: handle 'tip': no group 'nose'"));
}

TEST_F(Check, NamesDefectsOfTheMesh) {
  write("shot.yaml", test::minimal_shot);
  write("bar.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 9 9 9\nf 1 2 3\nf 1 2 3\nf 1 2 4\n");
  const ProgramResult result = run({"check", "shot.yaml", "--json"});
  EXPECT_THAT(result.errors, HasSubstr("1 duplicate face (1)"));
  EXPECT_THAT(result.errors, HasSubstr("1 non-manifold edge (0-1)"));
  EXPECT_THAT(result.errors, HasSubstr("1 unreferenced vertex (4)"));
}

}  // namespace
}  // namespace flexkey
