// Values by name.
#include <gtest/gtest.h>

#include "timeline/parsing.h"

namespace flexkey {
namespace {

TEST(Variables, StandForAValueOfAnyKind) {
  const Shot shot = parse(
      "vars: {stiff: 0.9, up: [0, 0, 2], top: {axis: z, above: 99%}}\n"
      "mesh: bar.obj\n"
      "handles: {tip: {select: $top, move: {keys: {1s: $up}}}}\n"
      "lambda: $stiff\n");
  EXPECT_EQ(shot.lambda.at(0).value, 0.9);
  EXPECT_EQ(shot.handles.at(0).move.at(0).value, Vec3(0, 0, 2));
}

TEST(Variables, MayStandForNumbersByTheirBareName) {
  const Shot shot = parse(
      "vars: {height: 2, when: 1.5s, much: 30deg}\n"
      "mesh: bar.obj\n"
      "handles: {tip: {select: {axis: z, above: 99%}, move: {keys: {when: [0, 0, height]}}, "
      "rotate: {axis: x, keys: {0s: much}}}}\n");
  EXPECT_EQ(shot.handles.at(0).move.at(0).value, Vec3(0, 0, 2));
  EXPECT_EQ(shot.handles.at(0).move.at(0).time, 1.5);
  EXPECT_NEAR(shot.handles.at(0).rotate.at(0).value.angle, 0.5235987755982988, 1e-15);
}

TEST(Variables, MayUseThoseAboveThem) {
  EXPECT_EQ(parse(with_base("vars: {a: 0.25, b: $a}\nlambda: $b\n")).lambda.at(0).value, 0.25);
  EXPECT_EQ(errors_of(with_base("vars: {b: $a, a: 0.25}\nlambda: $b\n")),
            "shot.yaml:4:11: error: unknown variable '$a'; such names are defined under 'vars'");
}

TEST(Variables, ComeAnewWithSet) {
  EXPECT_EQ(parse(with_base("vars: {a: 0.25}\nlambda: $a\n"), {{"vars.a", "0.75"}}).lambda.at(0).value, 0.75);
}

TEST(Variables, NameOutputs) {
  EXPECT_EQ(runs_of(with_base("vars: {size: 0.25, b: [1]}\noutput: x_<size>.glb\n")).at(0).gltf.path,
            "x_0.25.glb");
  EXPECT_EQ(errors_of(with_base("vars: {size: 0.25, b: [1]}\noutput: x_<b>.glb\n")),
            "shot.yaml:5:9: error: unknown placeholder '<b>' in output path 'x_<b>.glb'; known are <shot>, "
            "<lambda> and "
            "<size>");
}

TEST(Variables, WhatIsWrongIsSaidWithItsPlace) {
  EXPECT_EQ(errors_of(with_base("vars: {stiff: 1}\nlambda: $stif\n")),
            "shot.yaml:5:9: error: unknown variable '$stif'; did you mean '$stiff'?");
  EXPECT_EQ(errors_of(with_base("vars: {a: 2}\nlambda: $a\n")),
            "shot.yaml:5:9: error: lambda 2 is outside 0..1 (0 smooth, 1 most rigid)");
  EXPECT_EQ(
      errors_of(with_base("vars: {2a: 1}\n")),
      "shot.yaml:4:8: error: '2a' cannot name a variable; use letters, digits and _, with a letter first");
  EXPECT_EQ(errors_of(with_base("vars: [1]\n")),
            "shot.yaml:4:7: error: 'vars' must be a mapping such as {height: 2}, not a list");
}

TEST(Variables, CannotBlowTheTimelineUp) {
  std::string text = "vars:\n  a0: [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int k = 1; k < 12; ++k) {
    const std::string before = "$a" + std::to_string(k - 1);
    text +=
        "  a" + std::to_string(k) + ": [" + before + ", " + before + ", " + before + ", " + before + "]\n";
  }
  EXPECT_NE(errors_of(text + "mesh: a.obj\nhandles: {a: {select: {group: a}}}\n")
                .find("with its variables the timeline has more than 100000 values"),
            std::string::npos);
  std::string deep = "vars:\n  a0: [1]\n";
  for (int k = 1; k < 1000; ++k) deep += "  a" + std::to_string(k) + ": [$a" + std::to_string(k - 1) + "]\n";
  EXPECT_NE(errors_of(deep + "mesh: a.obj\nhandles: {a: {select: {group: a}}}\n")
                .find("error: with its variables, values are nested more than 64 deep"),
            std::string::npos);
}

}  // namespace
}  // namespace flexkey
