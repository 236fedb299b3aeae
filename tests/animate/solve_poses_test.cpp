#include "flexkey/animate/solve_poses.h"

#include <gtest/gtest.h>

#include "animate/shots.h"
#include "flexkey/animate/animate.h"

namespace flexkey {
namespace {

using test::held_bar;
using test::shot_of;

/// A bar of 3 units that stands on its held bottom; its top has two poses.
Shot posed_bar(const std::string& tip, const std::string& more = "") {
  return shot_of(held_bar + "  tip: {select: {axis: z, above: 100%}" + tip + "}\n" +
                 "poses:\n"
                 "  up: {tip: {move: [0, 0, 0.5]}}\n"
                 "  turned: {tip: {rotate: {axis: z, angle: 60deg}, move: [0.2, 0, 0]}}\n"
                 "output: {gltf: {path: a.glb, poses: all}}\n" +
                 more);
}

const Mesh& bar() {
  static const Mesh mesh = meshes::bar(2, 2, 6);
  return mesh;
}

std::vector<SolvedPose> solved(const Shot& shot) {
  return solve_poses(shot, bar(), {});
}

TEST(SolvePoses, HandlesAreWhereThePoseHasThem) {
  const std::vector<SolvedPose> poses = solved(posed_bar(""));
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[0].name, "up");
  EXPECT_EQ(poses[1].name, "turned");
  const Positions& rest = bar().positions;
  const double top = rest.col(2).maxCoeff();
  for (Eigen::Index v = 0; v < rest.rows(); ++v) {
    const Vec3 moved = (poses[0].positions.row(v) - rest.row(v)).transpose();
    if (rest(v, 2) == 0) {
      EXPECT_EQ(moved, Vec3(0, 0, 0));
    } else if (rest(v, 2) == top) {
      EXPECT_LT((moved - Vec3(0, 0, 0.5)).norm(), 1e-12);
    }
  }
  for (const SolvedPose& pose : poses) {
    EXPECT_TRUE(pose.report.converged) << pose.name;
    EXPECT_GT(pose.report.solves, 0);
  }
}

TEST(SolvePoses, IsWhatAShotOfTheSamePoseComesTo) {
  Shot shot = posed_bar("", "duration: 1s\n");
  const std::vector<SolvedPose> poses = solved(shot);
  const Shot held = shot_of(held_bar +
                            "  tip: {select: {axis: z, above: 100%}, rotate: {axis: z, keys: {0s: 60deg}}, "
                            "move: {keys: {0s: [0.2, 0, 0]}}}\n"
                            "duration: 1s\n");
  const Clip clip = animate(held, bar());
  EXPECT_LT((clip.frames.back() - poses[1].positions).rowwise().norm().maxCoeff(), 1e-9);
}

TEST(SolvePoses, WhatTheTimelineKeysHasNoPartInThem) {
  const std::vector<SolvedPose> plain = solved(posed_bar(""));
  const std::vector<SolvedPose> keyed =
      solved(posed_bar(", move: {keys: {0s: [1, 1, 1], 1s: [2, 0, 0]}}, wave: {amplitude: 0.3, along: x}",
                       "lambda: {0s: 0.5, 1s: 1}\n"));
  for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(plain[k].positions, keyed[k].positions);
  const std::vector<SolvedPose> stiff = solved(posed_bar("", "lambda: {0s: 1, 1s: 0.5}\n"));
  EXPECT_NE(plain[1].positions, stiff[1].positions) << "of λ the beginning counts";
}

TEST(SolvePoses, MirrorsAndParentsFollow) {
  const Shot shot = shot_of(
      "mesh: bar.obj\n"
      "handles:\n"
      "  low: {select: {axis: z, below: 0%}, mirror: {of: high, plane: z}}\n"
      "  high: {select: {axis: z, above: 100%}}\n"
      "poses: {apart: {high: {move: [0, 0, 1]}}}\n"
      "output: {gltf: {path: a.glb, poses: [apart]}}\n");
  const std::vector<SolvedPose> poses = solved(shot);
  const Positions moved = poses[0].positions - bar().positions;
  EXPECT_NEAR(moved.col(2).maxCoeff(), 1, 1e-9);
  EXPECT_NEAR(moved.col(2).minCoeff(), -1, 1e-9);
}

TEST(SolvePoses, HandlesThatHoldForATimeHoldWhereThePoseLeadsThem) {
  const Shot shot = shot_of(held_bar +
                            "  tip: {select: {axis: z, above: 100%}, active: [1s, 2s]}\n"
                            "  middle: {select: {vertices: [30]}, active: [1s, 2s]}\n"
                            "duration: 2s\n"
                            "poses: {up: {tip: {move: [0, 0, 0.5]}}}\n"
                            "output: {gltf: {path: a.glb, poses: all}}\n");
  const Positions moved = solved(shot)[0].positions - bar().positions;
  EXPECT_NEAR(moved.col(2).maxCoeff(), 0.5, 1e-9);
  EXPECT_GT(moved.row(30).norm(), 0.05) << "free, since the pose leaves it alone";
}

TEST(SolvePoses, MoreThanABatchOfThemAndAStop) {
  std::string text = held_bar + "  tip: {select: {axis: z, above: 100%}}\nposes:\n";
  for (int k = 0; k < 7; ++k)
    text += "  p" + std::to_string(k) + ": {tip: {move: [0, 0, 0." + std::to_string(k) + "]}}\n";
  const Shot shot = shot_of(text + "output: {gltf: {path: a.glb, poses: all}}\n");
  const std::vector<SolvedPose> poses = solved(shot);
  ASSERT_EQ(poses.size(), 7u);
  EXPECT_NEAR((poses[6].positions - bar().positions).col(2).maxCoeff(), 0.6, 1e-9);
  int asked = 0;
  EXPECT_LT(solve_poses(shot, bar(), [&] { return ++asked > 2; }).size(), 7u);
}

}  // namespace
}  // namespace flexkey
