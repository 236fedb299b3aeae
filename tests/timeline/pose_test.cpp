// Named poses, by keys and by cues.
#include <gtest/gtest.h>

#include <numbers>

#include "flexkey/timeline/sampling.h"
#include "timeline/parsing.h"

namespace flexkey {
namespace {

constexpr double pi = std::numbers::pi;

const std::string poses =
    "mesh: face.obj\n"
    "poses:\n"
    "  smile: {left: {move: [0, 1, 0], rotate: {axis: z, angle: 40deg}}, right: {scale: 2}}\n"
    "  sad: {left: {move: [0, -1, 0], rotate: {axis: z, angle: -20deg}}}\n";

std::string with_pose(const std::string& pose) {
  return poses + "handles:\n  left: {select: {group: a}, pose: " + pose +
         "}\n  right: {select: {group: b}, pose: " + pose + "}\n";
}

TEST(Pose, LeadsEachHandleThroughItsPoses) {
  const Shot shot = parse(with_pose("{keys: {0s: rest, 1s: smile, 3s: sad}}"));
  const auto left = [&](double t) { return sample_motion(shot.handles.at(0), Vec3::Zero(), t); };
  EXPECT_EQ(left(0).move, Vec3(0, 0, 0));
  EXPECT_EQ(left(1).move, Vec3(0, 1, 0));
  EXPECT_LT((left(2).move - Vec3(0, 0, 0)).norm(), 1e-12);
  const Eigen::Matrix3d ten(Eigen::AngleAxisd(10 * pi / 180, Vec3::UnitZ()));
  EXPECT_LT((left(2).turn() - ten).norm(), 1e-12);
  const auto right = [&](double t) { return sample_motion(shot.handles.at(1), Vec3::Zero(), t).scale; };
  EXPECT_EQ(right(1), Vec3(2, 2, 2));
  EXPECT_EQ(right(3), Vec3(1, 1, 1)) << "a pose that does not lead a handle has it at rest";
  EXPECT_EQ(shot.duration, 3);
}

TEST(Pose, ComesBesideTheHandlesOwnMotion) {
  const Shot shot =
      parse(poses +
            "handles: {left: {select: {group: a}, pose: {keys: {0s: smile}}, move: {keys: {0s: [5, 0, "
            "0]}}}, right: {select: {group: b}}}\n");
  EXPECT_EQ(sample_motion(shot.handles.at(0), Vec3::Zero(), 0).move, Vec3(5, 1, 0));
}

TEST(Pose, CuesComeFromAFile) {
  const Sources sources =
      files({{"talk.tsv", "# when\twhat\n0\trest\n12f\tsmile\n\n1.5s\tsad  # at last\n"}});
  const Shot shot = parse_shot(with_pose("{cues: talk.tsv, ease: hold}"), "shot.yaml", {}, sources).shot;
  EXPECT_EQ(shot.duration, 1.5);
  EXPECT_EQ(sample_motion(shot.handles.at(0), Vec3::Zero(), 0.5).move, Vec3(0, 1, 0));
  EXPECT_EQ(sample_motion(shot.handles.at(0), Vec3::Zero(), 1.4).move, Vec3(0, 1, 0));
  EXPECT_EQ(sample_motion(shot.handles.at(0), Vec3::Zero(), 1.5).move, Vec3(0, -1, 0));
}

std::string with_output(const std::string& wanted) {
  return poses + "handles: {left: {select: {group: a}}, right: {select: {group: b}}}\n" +
         "output: {gltf: {path: a.glb, poses: " + wanted + "}}\n";
}

TEST(Pose, TheGlbGetsThoseThatItNames) {
  const auto names_of = [](const Shot& shot) {
    std::vector<std::string> names;
    for (const PoseOutput& pose : shot.gltf.poses) names.push_back(pose.name);
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names_of(parse(with_output("all"))), (Names{"smile", "sad"})) << "in the file's order";
  EXPECT_EQ(names_of(parse(with_output("[sad]"))), Names{"sad"});
  EXPECT_EQ(names_of(parse(with_output("smile"))), Names{"smile"});
  EXPECT_EQ(names_of(parse("mesh: a.obj\nhandles: {h: {select: {group: a}}}\noutput: a.glb\n")), Names{});
  EXPECT_EQ(parse(with_output("[sad]")).gltf.poses[0].handles.at("left").move, Vec3(0, -1, 0));
}

TEST(Pose, AWrongNameForTheGlbIsSaidWithItsPlace) {
  EXPECT_EQ(errors_of(with_output("[smile, sat]")),
            "shot.yaml:6:45: error: unknown pose 'sat'; did you mean 'sad'?");
  EXPECT_EQ(errors_of(with_output("[sad, sad]")), "shot.yaml:6:43: error: the pose 'sad' stands here twice");
  EXPECT_EQ(errors_of(with_output("smil")),
            "shot.yaml:6:37: error: unknown pose 'smil'; did you mean 'smile'?");
  EXPECT_EQ(errors_of(with_output("[[sad]]")), "shot.yaml:6:38: error: a pose is a name, not a list");
  EXPECT_EQ(errors_of(with_output("{a: b}")), "shot.yaml:6:37: error: a pose is a name, not a mapping");
  EXPECT_EQ(errors_of(with_output("[]")),
            "shot.yaml:6:37: error: 'poses' lists no pose; write all, or names such as [smile]");
  EXPECT_EQ(
      errors_of(
          "mesh: a.obj\nhandles: {h: {select: {group: a}}}\noutput: {gltf: {path: a.glb, poses: all}}\n"),
      "shot.yaml:3:37: error: there are no poses; they are defined under 'poses'");
}

TEST(Pose, WhatIsWrongIsSaidWithItsPlace) {
  EXPECT_EQ(errors_of(with_pose("{keys: {0s: smil}}")),
            "shot.yaml:6:48: error: unknown pose 'smil'; did you mean 'smile'?\n"
            "shot.yaml:7:49: error: unknown pose 'smil'; did you mean 'smile'?");
  EXPECT_EQ(
      errors_of("mesh: a.obj\nposes: {smile: {lft: {scale: 1}}}\nhandles: {left: {select: {group: a}}}\n"),
      "shot.yaml:2:17: error: pose 'smile' has an unknown handle 'lft'; did you mean 'left'?");
  EXPECT_EQ(errors_of("mesh: a.obj\nposes: {rest: {}}\nhandles: {left: {select: {group: a}}}\n"),
            "shot.yaml:2:9: error: a pose cannot be named 'rest'; it stands for the rest pose");
  const std::string cues =
      poses +
      "handles:\n  left: {select: {group: a}, pose: {cues: talk.tsv}}\n  right: {select: {group: b}}\n";
  const auto errors = [&](const std::string& text) {
    return errors_of(cues, {}, files({{"talk.tsv", text}}));
  };
  EXPECT_EQ(errors("0 rest\nnow smile\n"),
            "shot.yaml:6:43: error: talk.tsv: line 2: 'now' is not a time; times are seconds (1.5s) or "
            "frames (36f)");
  EXPECT_EQ(
      errors("1 rest\n1 smile\n"),
      "shot.yaml:6:43: error: talk.tsv: line 2: the time 1 does not come after that of the line before");
  EXPECT_EQ(errors("1 rest smile\n"),
            "shot.yaml:6:43: error: talk.tsv: line 1: a time and a name belong on a line, not 3 words");
  EXPECT_EQ(errors("# none\n"), "shot.yaml:6:43: error: talk.tsv: it has no line with a time and a name");
  EXPECT_EQ(errors_of(cues), "shot.yaml:6:43: error: 'talk.tsv' cannot be read here");
}

}  // namespace
}  // namespace flexkey
