#include <gtest/gtest.h>

#include "timeline/parsing.h"

namespace flexkey {
namespace {

TEST(Placeholders, TakeTheShotsValues) {
  const Shot shot = parse(with_base("lambda: 0.2\noutput: <shot>/a_<lambda>.glb\n"));
  EXPECT_EQ(shot.gltf.path, "<shot>/a_<lambda>.glb") << "kept as written";
  EXPECT_EQ(expand_placeholders(shot.gltf.path, shot), "shot/a_0.2.glb");
  EXPECT_EQ(expand_placeholders("a < b > c.glb", shot), "a < b > c.glb");
  EXPECT_EQ(expand_placeholders("<<shot>>", shot), "<shot>");
  EXPECT_EQ(expand_placeholders("<", shot), "<");
}

TEST(Placeholders, NumbersAreAsShortAsTheyCanBe) {
  const auto expanded = [](const std::string& lambda) {
    const Shot shot = parse(with_base("lambda: " + lambda + "\n"));
    return expand_placeholders("<lambda>", shot);
  };
  EXPECT_EQ(expanded("1"), "1");
  EXPECT_EQ(expanded("0.50"), "0.5");
  EXPECT_EQ(expanded("-0"), "0");
  EXPECT_EQ(expanded("0.1"), "0.1");
}

TEST(Placeholders, OfTheShotOnStandardInput) {
  EXPECT_EQ(parse_shot(with_base("output: <shot>.glb\n"), "-").runs.at(0).gltf.path, "stdin.glb");
}

TEST(Runs, WithoutASweepAreTheShotItself) {
  const std::vector<Shot> runs = runs_of(with_base("lambda: {0s: 0, 1s: 1}\noutput: <shot>.glb\n"));
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].gltf.path, "shot.glb");
  EXPECT_EQ(runs[0].lambda.size(), 2u);
}

TEST(Runs, OfASweepHaveOneLambdaEach) {
  const std::vector<Shot> runs =
      runs_of(with_base("lambda: {0s: 0, 2s: 1}\nsweep: {lambda: [0, 0.2, 1]}\noutput: a_<lambda>.glb\n"));
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_EQ(runs[0].gltf.path, "a_0.glb");
  EXPECT_EQ(runs[1].gltf.path, "a_0.2.glb");
  EXPECT_EQ(runs[2].gltf.path, "a_1.glb");
  for (const Shot& run : runs) {
    EXPECT_EQ(run.lambda.size(), 1u);
    EXPECT_EQ(run.duration, 0) << "as with --set lambda=…";
  }
  EXPECT_EQ(runs[1].lambda[0].value, 0.2);
}

TEST(Runs, OfASweepHaveAPageEach) {
  const std::vector<Shot> runs =
      runs_of(with_base("sweep: {lambda: [0, 1]}\noutput: {html: <shot>_<lambda>.html}\n"));
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].html.path, "shot_0.html");
  EXPECT_EQ(runs[1].html.path, "shot_1.html");
}

TEST(Runs, OfOneValueNeedNoPlaceholder) {
  const std::vector<Shot> runs = runs_of(with_base("sweep: {lambda: [0.3]}\noutput: a.glb\n"));
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].gltf.path, "a.glb");
  EXPECT_EQ(runs[0].lambda.at(0).value, 0.3);
}

}  // namespace
}  // namespace flexkey
