// Poses of the timeline as targets of the GLB.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/work_folder.h"
#include "flexkey/gltf/read_gltf.h"

namespace flexkey {
namespace {

using nlohmann::json;
using test::ProgramResult;
using testing::HasSubstr;

class Poses : public test::WorkFolder {
 protected:
  static std::string shot(const std::string& gltf, const std::string& tip = "") {
    return "mesh: bar.obj\n"
           "poses:\n"
           "  up: {tip: {move: [0, 0, 2]}}\n"
           "  turned: {tip: {rotate: {axis: z, angle: 60deg}}}\n"
           "handles:\n"
           "  base: {select: {axis: z, below: 1%}}\n"
           "  tip: {select: {axis: z, above: 99%}, pose: {keys: {0s: rest, 1s: up}}" +
           tip + "}\noutput: {gltf: {path: bar.glb, " + gltf + "}}\n";
  }
};

TEST_F(Poses, AreTargetsOfTheirNamesAndReported) {
  write("shot.yaml", shot("poses: all"));
  const ProgramResult result = run({"animate", "shot.yaml", "--json", "--strict"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("up, turned; all converged"));
  const json report = json::parse(result.output)["runs"][0];
  ASSERT_EQ(report["poses"].size(), 2u);
  EXPECT_EQ(report["poses"][1]["name"], "turned");
  EXPECT_EQ(report["poses"][1]["converged"], true);
  EXPECT_LT(report["outputs"][0]["pose_error"], 1e-4);
  const json root = json::parse(read_gltf(folder() / "bar.glb").source.document.json);
  const json& names = root["meshes"][0]["extras"]["targetNames"];
  EXPECT_EQ(names[names.size() - 2], "up");
  EXPECT_EQ(names.back(), "turned");
}

TEST_F(Poses, AreSolvedAgainFromAKeptState) {
  write("shot.yaml", shot("poses: [turned]"));
  ASSERT_EQ(run({"solve", "shot.yaml"}).exit_code, 0);
  const ProgramResult result = run({"export", "shot.yaml", "--no-solve", "--json", "-q"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(json::parse(result.output)["runs"][0]["poses"][0]["name"], "turned");
}

TEST_F(Poses, OneThatDoesNotConvergeIsSaid) {
  write("shot.yaml",
        shot("poses: [turned]") + "duration: 0s\nlambda: 1\nsolver: {iterations: 1, tolerance: 1e-9}\n");
  const ProgramResult result = run({"animate", "shot.yaml", "--strict"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_THAT(result.errors, HasSubstr("not converged: turned"));
  EXPECT_THAT(result.errors, HasSubstr("did not converge (--strict)"));
}

TEST_F(Poses, WhatNothingWouldHoldIsRefusedBeforeTheSolve) {
  write("shot.yaml",
        "mesh: bar.obj\n"
        "poses: {up: {tip: {move: [0, 0, 2]}}, none: {}}\n"
        "duration: 1s\n"
        "handles:\n"
        "  tip: {select: {axis: z, above: 99%}, active: [0s, 5s]}\n"
        "output: {gltf: {path: bar.glb, poses: all}}\n");
  for (const char* command : {"check", "animate"}) {
    const ProgramResult result = run({command, "shot.yaml"});
    EXPECT_EQ(result.exit_code, 2) << result.errors;
    EXPECT_THAT(result.errors, HasSubstr("shot.yaml:"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder() / "bar.glb"));
}

TEST_F(Poses, CountAmongTheTargetsOfAnExactFile) {
  write("shot.yaml", shot("poses: all, profile: exact, max_targets: 26"));
  const ProgramResult result = run({"check", "shot.yaml"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors,
              HasSubstr("25 frames and 2 poses make as many morph targets, above max_targets, 26"));
}

}  // namespace
}  // namespace flexkey
