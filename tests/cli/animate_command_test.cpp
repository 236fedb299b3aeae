#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/work_folder.h"
#include "flexkey/gltf/read_gltf.h"
#include "flexkey/mesh/obj.h"
#include "flexkey/mesh/read_file.h"

namespace flexkey {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::ProgramResult;
using testing::HasSubstr;
using testing::StartsWith;

class Animate : public test::WorkFolder {};

TEST_F(Animate, WritesTheGlbThatTheTimelineNames) {
  write("shot.yaml", test::minimal_shot);
  const ProgramResult result = run({"animate", "shot.yaml", "-d", "made/out"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(read_file(folder() / "made/out/bar.glb"), StartsWith("glTF"));
  EXPECT_EQ(result.output, "made/out/bar.glb\n");
  EXPECT_THAT(result.errors, HasSubstr("Progress: 100%"));
  EXPECT_THAT(result.errors, HasSubstr("every frame converged"));
}

TEST_F(Animate, TheReportIsJsonAndNothingElseOnStandardOutput) {
  write("shot.yaml", test::minimal_shot);
  const ProgramResult result = run({"animate", "shot.yaml", "--json", "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
  const json run_report = json::parse(result.output)["runs"][0];
  EXPECT_EQ(run_report["frames"], 25);
  EXPECT_EQ(run_report["outputs"][0]["path"], "./bar.glb");
  EXPECT_EQ(run_report["outputs"][0]["bytes"], fs::file_size(folder() / "bar.glb"));
  EXPECT_EQ(run_report["frame_reports"][24]["frame"], 24);
}

TEST_F(Animate, TheSameInputGivesTheSameBytes) {
  write("shot.yaml", test::minimal_shot);
  run({"animate", "shot.yaml", "-d", "a", "--threads", "1"});
  run({"animate", "shot.yaml", "-d", "b", "--threads", "2"});
  EXPECT_EQ(read_file(folder() / "a/bar.glb"), read_file(folder() / "b/bar.glb"));
}

TEST_F(Animate, ASweepWritesARunForEachValue) {
  write("shot.yaml", std::string(test::minimal_shot) + "sweep: {lambda: [0, 0.5, 1]}\n");
  const ProgramResult result = run({"animate", "shot.yaml", "--set", "output=bar_<lambda>.glb"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.output, "./bar_0.glb\n./bar_0.5.glb\n./bar_1.glb\n");
}

TEST_F(Animate, ASweptRunEqualsASingleOne) {
  write("shot.yaml", std::string(test::minimal_shot) + "sweep: {lambda: [0, 0.5]}\n");
  run({"animate", "shot.yaml", "--json", "--set", "output=<lambda>/bar.glb"});
  write("alone.yaml", std::string(test::minimal_shot) + "lambda: 0.5\n");
  const json alone = json::parse(run({"animate", "alone.yaml", "--json", "-q"}).output);
  const json swept =
      json::parse(run({"animate", "shot.yaml", "--json", "-q", "--set", "output=<lambda>/bar.glb"}).output);
  EXPECT_EQ(alone["runs"][0]["frame_reports"], swept["runs"][1]["frame_reports"]);
}

TEST_F(Animate, StrictExitsFourWhereAFrameDidNotConverge) {
  write("shot.yaml", std::string(test::minimal_shot) + "solver: {iterations: 1, tolerance: 0.000001%}\n");
  const ProgramResult strict = run({"animate", "shot.yaml", "--strict", "--quiet"});
  EXPECT_EQ(strict.exit_code, 4);
  EXPECT_EQ(strict.errors, "flexkey: error: 24 of 25 frames did not converge (--strict)\n");
  EXPECT_TRUE(fs::exists(folder() / "bar.glb"));
  const ProgramResult loose = run({"animate", "shot.yaml"});
  EXPECT_EQ(loose.exit_code, 0);
  EXPECT_THAT(loose.errors, HasSubstr("of 25 frames did not converge (1, 2,"));
}

TEST_F(Animate, FramesThatLostATurnAreReported) {
  write("shot.yaml", test::minimal_shot);
  const ProgramResult result =
      run({"animate", "shot.yaml", "--json", "--set", "handles.tip.rotate.keys={0s: 0deg, 1s: 540deg}"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("the surface lost a turn that its handles made"));
  const json run_report = json::parse(result.output)["runs"][0];
  ASSERT_FALSE(run_report["slipped"].empty());
  EXPECT_EQ(run_report["slipped"].back(), 24);
  EXPECT_EQ(run_report["frame_reports"][1]["slipped"], false);
  EXPECT_EQ(run_report["frame_reports"][24]["slipped"], true);
}

TEST_F(Animate, PresetPaperClaimsNoConvergenceAndStrictDoesNotAsk) {
  write("shot.yaml", std::string(test::minimal_shot) + "solver: {preset: paper}\n");
  const ProgramResult result = run({"animate", "shot.yaml", "--strict"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("no convergence claimed"));
}

TEST_F(Animate, MoreFramesThanMorphTargetsAreRefusedBeforeTheSolve) {
  write("shot.yaml", std::string(test::minimal_shot) + "duration: 9s\n");
  std::vector<std::string> arguments{"animate", "shot.yaml", "--set",
                                     "output={gltf: {path: b.glb, profile: exact}}"};
  const ProgramResult result = run(arguments);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors,
              HasSubstr("error: 217 frames make as many morph targets, above max_targets, 200"));
  arguments.back() = "output={gltf: {path: b.glb, profile: exact, max_targets: 300}}";
  EXPECT_EQ(run(arguments).exit_code, 0);
  EXPECT_EQ(run({"animate", "shot.yaml"}).exit_code, 0) << "compat takes fewer";
}

TEST_F(Animate, AMeshWhoseUpwardAxisIsZStandsUprightInGltfAndUsd) {
  write("shot.yaml", test::minimal_shot);
  for (const std::string up : {"y", "z"})
    ASSERT_EQ(run({"animate", "shot.yaml", "--set", "mesh={file: bar.obj, up: " + up + "}", "--set",
                   "output={gltf: {path: bar.glb, handles: true}, html: bar.html, usd: bar.usda}", "-d", up})
                  .exit_code,
              0);
  const Mesh bar = read_obj(folder() / "bar.obj").mesh, lying = read_gltf(folder() / "y/bar.glb").file.mesh,
             standing = read_gltf(folder() / "z/bar.glb").file.mesh;
  EXPECT_TRUE(bounds_of(lying.positions).max.isApprox(bounds_of(bar.positions).max, 1e-6));
  const Bounds up = bounds_of(standing.positions), file = bounds_of(bar.positions);
  EXPECT_TRUE(up.max.isApprox(Vec3(file.max.x(), file.max.z(), -file.min.y()), 1e-6));
  EXPECT_TRUE(up.min.isApprox(Vec3(file.min.x(), file.min.z(), -file.max.y()), 1e-6));
  EXPECT_THAT(read_file(folder() / "y/bar.usda"), HasSubstr("upAxis = \"Y\""));
  EXPECT_THAT(read_file(folder() / "z/bar.usda"), HasSubstr("upAxis = \"Z\""));
}

TEST_F(Animate, TheReportIsAFileToo) {
  write("shot.yaml", test::minimal_shot);
  const std::string output = "output={gltf: <lambda>.glb, report: <shot>.json}";
  ASSERT_EQ(run({"animate", "shot.yaml", "--set", output, "--set", "sweep={lambda: [0, 1]}"}).exit_code, 0);
  const json report = json::parse(read_file(folder() / "shot.json"));
  ASSERT_EQ(report["runs"].size(), 2u);
  EXPECT_EQ(report["runs"][1]["outputs"][0]["path"], "./1.glb");
  EXPECT_EQ(run({"sweep", "shot.yaml", "--set", output, "--set", "sweep={lambda: [0, 1]}", "--chunk", "2/2"})
                .exit_code,
            0);
  EXPECT_EQ(json::parse(read_file(folder() / "shot.2-of-2.json"))["runs"].size(), 1u);
  EXPECT_THAT(run({"animate", "shot.yaml", "--set", "output={gltf: a.glb, report: shot.yaml}"}).errors,
              HasSubstr("--set output: error: the output './shot.yaml' would replace an input"));
}

TEST_F(Animate, AShotWithoutAnOutputIsToldWhatToAdd) {
  write("shot.yaml", "mesh: bar.obj\nhandles: {base: {select: {axis: z, below: 1%}}}\n");
  const ProgramResult result = run({"animate", "shot.yaml"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("add 'output: shot.glb'"));
}

}  // namespace
}  // namespace flexkey
