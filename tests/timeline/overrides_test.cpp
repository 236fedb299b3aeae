#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "timeline/parsing.h"

namespace flexkey {
namespace {

TEST(Overrides, ReplaceAValue) {
  EXPECT_EQ(parse(with_base("fps: 24\n"), {{"fps", "30"}}).fps, 30);
  EXPECT_EQ(parse(with_base(""), {{"mesh", "other.obj"}}).mesh.file, "other.obj");
}

TEST(Overrides, TheLastOneWins) {
  EXPECT_EQ(parse(with_base(""), {{"fps", "30"}, {"fps", "60"}}).fps, 60);
}

TEST(Overrides, MakeMissingMappings) {
  EXPECT_EQ(parse(with_base(""), {{"solver.iterations", "7"}}).solver.iterations, 7);
  const Shot shot =
      parse(with_base(""), {{"handles.tip.select.axis", "z"}, {"handles.tip.select.above", "99%"}});
  ASSERT_EQ(shot.handles.size(), 2u);
  EXPECT_EQ(shot.handles[1].name, "tip");
}

TEST(Overrides, TakeYamlValues) {
  EXPECT_EQ(parse(with_base(""), {{"lambda", "{0s: 0, 2s: 1}"}}).lambda.size(), 2u);
  EXPECT_EQ(runs_of(with_base(""), {{"sweep", ""}, {"sweep", "{lambda: [0, 1]}"}}).size(), 2u);
}

TEST(Overrides, ReachIntoListsAndKeysWithDots) {
  const std::vector<Shot> runs = runs_of(with_base("lambda: {0s: 0, 1.5s: 1}\nsweep: {fps: [24, 30, 60]}\n"),
                                         {{"lambda.1.5s", "0.25"}, {"sweep.fps.1", "25"}});
  EXPECT_EQ(runs.at(0).lambda.at(1).value, 0.25);
  EXPECT_EQ(runs.at(1).fps, 25);
}

TEST(Overrides, DoNotReachOtherUsesOfAnAnchor) {
  const std::string text =
      "mesh: bar.obj\nhandles:\n  a: &a\n    select: {axis: z, below: 1%}\n    move: {keys: {0s: [0, 0, "
      "0]}}\n  b: *a\n";
  const Shot shot = parse(text, {{"handles.b.move.keys.0s", "[0, 0, 9]"}});
  EXPECT_EQ(shot.handles.at(0).move.at(0).value, Vec3(0, 0, 0));
  EXPECT_EQ(shot.handles.at(1).move.at(0).value, Vec3(0, 0, 9));
}

TEST(Overrides, ErrorsNameTheOverride) {
  EXPECT_EQ(errors_of(with_base(""), {{"fps", "24"}, {"lambda", "1.2"}}),
            "--set lambda: error: lambda 1.2 is outside 0..1 (0 smooth, 1 most rigid)");
  EXPECT_EQ(errors_of(with_base(""), {{"lamda", "1"}}),
            "--set lamda: error: unknown key 'lamda'; did you mean 'lambda'?");
  EXPECT_EQ(errors_of(with_base(""), {{"mesh.weld", "1%"}}),
            "--set mesh.weld: error: 'mesh' is 'bar.obj', not a mapping; set 'mesh' itself");
  EXPECT_EQ(errors_of(with_base("sweep: {lambda: [0]}\n"), {{"sweep.lambda.3", "1"}}),
            "--set sweep.lambda.3: error: '3' is no item of the list 'sweep.lambda', which has 1");
  EXPECT_EQ(errors_of(with_base(""), {{"solver..epsilon", "1"}}),
            "--set solver..epsilon: error: a key path is keys joined by dots, such as solver.iterations");
  EXPECT_EQ(errors_of(with_base(""), {{"", "1"}}),
            "--set : error: a key path is keys joined by dots, such as solver.iterations");
  EXPECT_EQ(errors_of(with_base(""), {{"lambda", "[1"}}),
            "--set lambda: error: a ',' or ']' is missing here; the list began at 1:1");
  EXPECT_EQ(errors_of(with_base(""), {{"lambda", ""}}), "--set lambda: error: 'lambda' has no value");
  EXPECT_EQ(errors_of(with_base(""), {{"points", "{a: [0, 0, 0], a: [1, 1, 1]}"}}),
            "--set points: error: duplicate key 'a'");
}

TEST(Overrides, ErrorsOfTheFileKeepTheirPlace) {
  EXPECT_EQ(errors_of(with_base("lambda: 2\n"), {{"fps", "-1"}}),
            "--set fps: error: fps -1 is outside 0..1000 (frames a second, above 0)\n"
            "shot.yaml:4:9: error: lambda 2 is outside 0..1 (0 smooth, 1 most rigid)");
}

TEST(Overrides, PlacesSurviveForErrorsThatShowLater) {
  const std::vector<Override> overrides = {{"fps", "30"}, {"handles.base.select", "{group: leg}"}};
  const Shot shot = parse(with_base(""), overrides);
  const Mark where = shot.handles.at(0).select.where;
  EXPECT_EQ(format_diagnostic("shot.yaml", error_at(where, "no group 'leg'", overrides)),
            "--set handles.base.select: error: no group 'leg'");
  EXPECT_EQ(format_diagnostic("shot.yaml", error_at({3, 4}, "no group 'leg'", overrides)),
            "shot.yaml:3:4: error: no group 'leg'");
}

}  // namespace
}  // namespace flexkey
