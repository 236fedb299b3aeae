// Handles that inherit and mirror the motions of others.
#include <gtest/gtest.h>

#include <numbers>

#include "animate/shots.h"
#include "flexkey/animate/animate.h"
#include "flexkey/animate/handle_states.h"

namespace flexkey {
namespace {

using test::shot_of;

constexpr double pi = std::numbers::pi;

Scene scene_of(const std::string& handles) {
  return bind_shot(shot_of(test::held_bar + handles), meshes::bar(2, 2, 8));
}

const std::string arm =
    "  shoulder: {select: {axis: z, above: 50%, below: 50%}, pivot: [0, 0, 4], "
    "rotate: {axis: y, keys: {0s: 0deg, 1s: 90deg}}}\n";

TEST(Parent, ItsWholeMotionComesAfterTheHandlesOwn) {
  const Scene scene = scene_of(arm +
                               "  hand: {select: {axis: z, above: 100%}, parent: shoulder, "
                               "move: {keys: {0s: [0, 0, 0], 1s: [0, 0, 2]}}}\n");
  const Positions targets = targets_of(scene, sample_states(scene, 1), 2);
  const Positions& rest = scene.handles.at(2).rest;
  for (Eigen::Index v = 0; v < rest.rows(); ++v) {
    const Vec3 x = rest.row(v);
    EXPECT_LT((targets.row(v).transpose() - Vec3(x.z() + 2 - 4, x.y(), 4 - x.x())).norm(), 1e-12);
  }
  EXPECT_LT((whole_motion(scene, sample_states(scene, 1), 2) * Vec3(0, 0, 8) - Vec3(6, 0, 4)).norm(), 1e-12);
}

TEST(Parent, TurnsOfBothAddUpWholeTurnsCounted) {
  const Scene scene = scene_of(
      "  shoulder: {select: {axis: z, above: 50%, below: 50%}, rotate: {axis: z, keys: {0s: 0deg, 1s: "
      "360deg}}}\n"
      "  hand: {select: {axis: z, above: 100%}, parent: shoulder, rotate: {axis: z, keys: {0s: 0deg, 1s: "
      "540deg}}}\n");
  const Positions turns = turns_between(scene, sample_states(scene, 0), sample_states(scene, 1));
  EXPECT_LT((turns.row(2) - Eigen::RowVector3d(0, 0, 5 * pi)).norm(), 1e-12);
}

TEST(Parent, AHandleWithoutMotionOfItsOwnRidesRigidly) {
  const Mesh bar = meshes::bar(2, 2, 8);
  const std::string text =
      test::held_bar + arm + "  hand: {select: {axis: z, above: 100%}, parent: shoulder}\n";
  const Clip clip = animate(shot_of(text), bar);
  const Eigen::Matrix3d R(Eigen::AngleAxisd(pi / 2, Vec3::UnitY()));
  for (int v = 0; v < bar.vertex_count(); ++v) {
    const Vec3 x = bar.positions.row(v);
    if (x.z() < 8) continue;
    EXPECT_LT((clip.frames.back().row(v).transpose() - (R * (x - Vec3(0, 0, 4)) + Vec3(0, 0, 4))).norm(),
              1e-9);
  }
}

TEST(Parent, OfACurveIsTheMotionThatFitsIt) {
  const Scene scene = scene_of(
      "  ridge: {select: {path: [[0, 0, 4], [2, 0, 4]]}, curve: {keys: {0s: rest, 1s: {polyline: [[5, 0, 4], "
      "[5, 2, 4]]}}}}\n"
      "  hand: {select: {axis: z, above: 100%}, parent: ridge}\n");
  const HandleStates states = sample_states(scene, 1);
  EXPECT_LT((whole_motion(scene, states, 2) * Vec3(2, 0, 8) - Vec3(5, 2, 8)).norm(), 1e-9);
  const Positions turns = turns_between(scene, sample_states(scene, 0), states);
  EXPECT_NEAR(turns(2, 2), pi / 2, 1e-9);
}

TEST(Mirror, GivesASymmetricSurface) {
  Mesh bar = meshes::bar(4, 2, 8);
  bar.positions.col(0).array() -= 2;  // symmetric about x = 0
  const std::string both =
      "  left: {select: {box: {min: [1.5, -1, 7], max: [3, 3, 9]}}, move: {keys: {0s: [0, 0, 0], 0.25s: [1, "
      "0.5, 0]}}, "
      "rotate: {axis: y, keys: {0s: 0deg, 0.25s: 40deg}}}\n"
      "  right: {select: {box: {min: [-3, -1, 7], max: [-1.5, 3, 9]}}, mirror: {of: left, plane: x}}\n";
  const Scene scene = bind_shot(shot_of(test::held_bar + both), bar);
  const HandleStates states = sample_states(scene, 0.25);
  const Positions left = targets_of(scene, states, 1), right = targets_of(scene, states, 2);
  const Positions &rest_left = scene.handles.at(1).rest, &rest_right = scene.handles.at(2).rest;
  ASSERT_EQ(left.rows(), right.rows());
  const Eigen::RowVector3d across(-1, 1, 1);
  for (Eigen::Index a = 0; a < left.rows(); ++a)
    for (Eigen::Index b = 0; b < right.rows(); ++b)
      if ((rest_left.row(a).cwiseProduct(across) - rest_right.row(b)).norm() < 1e-12) {
        EXPECT_LT((left.row(a).cwiseProduct(across) - right.row(b)).norm(), 1e-12);
      }
}

TEST(Mirror, MayComeLater) {
  const Scene scene = scene_of(
      "  left: {select: {axis: z, above: 100%}, move: {keys: {0s: [0, 0, 0], 1s: [1, 0, 0]}}}\n"
      "  right: {select: {axis: z, above: 50%, below: 50%}, mirror: {of: left, plane: x}, delay: 0.5s}\n");
  EXPECT_NEAR(sample_states(scene, 1).motions.at(2).move.x(), -0.5, 1e-12);
  EXPECT_NEAR(sample_states(scene, 0.25).motions.at(2).move.x(), 0, 1e-12);
}

}  // namespace
}  // namespace flexkey
