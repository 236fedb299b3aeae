// Sweeps: which runs they have, and that each is what `--set` would make.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "timeline/parsing.h"

namespace flexkey {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Sweeps, AreAGridWhoseLastKeyIsFastest) {
  const std::vector<Shot> runs =
      runs_of(with_base("sweep: {solver.iterations: [3, 4], lambda: [0, 1]}\n"
                        "output: <solver.iterations>_<lambda>.glb\n"));
  std::vector<std::string> paths;
  for (const Shot& run : runs) paths.push_back(run.gltf.path);
  EXPECT_THAT(paths, ElementsAre("3_0.glb", "3_1.glb", "4_0.glb", "4_1.glb"));
  EXPECT_EQ(runs[2].solver.iterations, 4);
  EXPECT_EQ(runs[2].lambda.at(0).value, 0);
  EXPECT_EQ(runs[2].run, 2);
}

TEST(Sweeps, ReachAnyKey) {
  const std::vector<Shot> runs = runs_of(
      with_tip("    rotate: {axis: z, keys: {0s: 0deg, 2s: 90deg}}\n"
               "sweep: {handles.tip.rotate.keys.2s: [45deg, 90deg], fps: [30]}\noutput: a_<run>.glb\n"));
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_NEAR(runs[0].handles.at(0).rotate.at(1).value.angle, 0.785398163, 1e-9);
  EXPECT_EQ(runs[1].fps, 30);
  EXPECT_EQ(runs[1].gltf.path, "a_1.glb");
  EXPECT_EQ(runs[0].swept.at(0).text, "45deg");
  EXPECT_FALSE(runs[0].swept.at(1).varies);
}

TEST(Sweeps, OfVariablesAreNamedByThem) {
  const std::vector<Shot> runs =
      runs_of(with_base("vars: {stiff: 1}\nlambda: $stiff\nsweep: {vars.stiff: [0.25, 0.5]}\noutput: "
                        "<stiff>.glb\n"));
  EXPECT_EQ(runs.at(1).gltf.path, "0.5.glb");
  EXPECT_EQ(runs.at(1).lambda.at(0).value, 0.5);
}

TEST(Sweeps, OfWhatIsNoWordAreNamedByTheirPlace) {
  const std::vector<Shot> runs =
      runs_of(with_base("sweep: {lambda: [{0s: 0, 1s: 1}, 0.5]}\noutput: a_<lambda>.glb\n"));
  EXPECT_EQ(runs.at(0).gltf.path, "a_0.glb");
  EXPECT_EQ(runs.at(0).lambda.size(), 2u);
  EXPECT_EQ(runs.at(1).gltf.path, "a_0.5.glb");
}

TEST(Sweeps, ThatDoNotVaryNeedNotBeNamed) {
  EXPECT_EQ(runs_of(with_base("sweep: {fps: [30]}\noutput: a.glb\n")).at(0).gltf.path, "a.glb");
}

TEST(Sweeps, ComeFromATable) {
  const std::string text = with_base(
      "sweep: {csv: runs.csv}\noutput: a_<lambda>_<points.top>.glb\n"
      "points: {top: [0, 0, 0]}\n");
  const Sources table =
      files({{"runs.csv", "lambda, points.top\n0.2, \"[0, 0, 1]\"\n# not this\n0.4, \"[0, 0, 2]\"\n"}});
  const std::vector<Shot> runs = runs_of(text, {}, table);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].gltf.path, "a_0.2_2.glb") << "by its line";
  EXPECT_EQ(runs[1].gltf.path, "a_0.4_4.glb");
  EXPECT_EQ(runs[1].lambda.at(0).value, 0.4);
}

TEST(Sweeps, NameThePlaceOfWhatIsWrong) {
  EXPECT_EQ(errors_of(with_base("sweep: {lamda: [0, 1]}\n")),
            "shot.yaml:4:9: error: unknown key 'lamda'; did you mean 'lambda'?");
  EXPECT_EQ(errors_of(with_base("sweep: {fps: [24, 0, 30, -1]}\n")),
            "shot.yaml:4:19: error: fps 0 is outside 0..1000 (frames a second, above 0)\n"
            "shot.yaml:4:26: error: fps -1 is outside 0..1000 (frames a second, above 0)");
  EXPECT_EQ(errors_of(with_base("sweep: {mesh.weld: [0, 1]}\n")),
            "shot.yaml:4:9: error: 'mesh' is 'bar.obj', not a mapping; set 'mesh' itself");
  EXPECT_EQ(errors_of(with_base("sweep: {csv: a.csv, lambda: [0]}\n")),
            "shot.yaml:4:21: error: 'csv' stands alone in a sweep; make 'lambda' a column of it");
  EXPECT_EQ(errors_of(with_base("sweep: {csv: [a]}\n")),
            "shot.yaml:4:14: error: 'csv' is a path, not a list");
  EXPECT_EQ(errors_of(with_base("sweep:\n")), "shot.yaml:4:1: error: 'sweep' has no value");
  EXPECT_EQ(errors_of(with_base("sweep: {fps: [1, 2], lambda: [0, 1]}\noutput: a_<fps>.glb\n")),
            "shot.yaml:5:9: error: output path 'a_<fps>.glb' does not name the swept key; write '<lambda>' "
            "into it");
}

TEST(Sweeps, OfATableNameTheLineOfWhatIsWrong) {
  const auto errors = [](const std::string& table) {
    return errors_of(with_base("sweep: {csv: runs.csv}\n"), {}, files({{"runs.csv", table}}));
  };
  EXPECT_EQ(errors("lambda\n0.5\n2\n"),
            "shot.yaml:4:14: error: lambda 2 is outside 0..1 (0 smooth, 1 most rigid) (line 3 of runs.csv)");
  EXPECT_EQ(errors("lambda,fps\n0.5\n"), "shot.yaml:4:14: error: runs.csv: line 2: 1 cells, where 2 belong");
  EXPECT_EQ(errors("lambda\n"),
            "shot.yaml:4:14: error: runs.csv: it has no line of values behind the line of keys");
  EXPECT_EQ(errors("lambda,lambda\n0,1\n"), "shot.yaml:4:14: error: runs.csv: two columns are of 'lambda'");
  EXPECT_EQ(errors("lambda\n[0\n").substr(0, 41), "shot.yaml:4:14: error: runs.csv: line 2: ");
  EXPECT_THAT(errors_of(with_base("sweep: {csv: none.csv}\n"), {}, files({})),
              HasSubstr("4:14: error: cannot read 'none.csv'"));
}

TEST(Sweeps, WouldNotWriteAFileTwice) {
  EXPECT_EQ(errors_of(with_base("vars: {a: 1, b: 1}\nsweep: {vars.a: [1, 11], vars.b: [11, 1]}\noutput: "
                                "x<a><b>.glb\n")),
            "shot.yaml:6:9: error: runs 0 and 3 of the sweep would both write 'x111.glb'; write '<run>' into "
            "the path")
      << "1 and 11, or 11 and 1";
}

TEST(Sweeps, OfTooManyRunsAreRefused) {
  std::string list = "[0";
  for (int k = 1; k < 101; ++k) list += ", " + std::to_string(k);
  list += "]";
  EXPECT_THAT(errors_of(with_base("sweep: {a: " + list + ", b: " + list + "}\n")),
              HasSubstr("the sweep has more than 10000 runs"));
}

}  // namespace
}  // namespace flexkey
