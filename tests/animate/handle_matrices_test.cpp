#include "flexkey/animate/handle_matrices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "animate/shots.h"

namespace flexkey {
namespace {

using test::shot_of;

/// The matrix of handle 'tip' of a bar at 1 s.
Eigen::Matrix4d matrix_of_tip(const std::string& lines) {
  const Mesh bar = meshes::bar(2, 2, 8);
  const Scene scene = bind_shot(shot_of(test::held_bar + "  tip:\n" + lines), bar);
  const std::vector<Eigen::Matrix4d> matrices = handle_matrices(scene, 1);
  EXPECT_EQ(matrices.size(), 2u);
  EXPECT_EQ(matrices.at(0), Eigen::Matrix4d::Identity()) << "the anchor";
  return matrices.at(1);
}

Vec3 apply(const Eigen::Matrix4d& matrix, const Vec3& point) {
  return (matrix * point.homogeneous()).head<3>();
}

TEST(HandleMatrices, ScaleThenTurnThenMoveAboutThePivot) {
  const Eigen::Matrix4d matrix = matrix_of_tip(
      "    select: {axis: z, above: 100%}\n"
      "    pivot: [1, 1, 8]\n"
      "    scale: {keys: {0s: 1, 1s: [2, 1, 1]}}\n"
      "    rotate: {axis: z, keys: {0s: 0deg, 1s: 90deg}}\n"
      "    move: {keys: {0s: [0, 0, 0], 1s: [0, 0, 3]}}\n");
  EXPECT_LT((apply(matrix, {1, 1, 8}) - Vec3(1, 1, 11)).norm(), 1e-12) << "the pivot only moves";
  EXPECT_LT((apply(matrix, {2, 1, 8}) - Vec3(1, 3, 11)).norm(), 1e-12) << "twice as long, then turned";
  EXPECT_LT((apply(matrix, {1, 2, 8}) - Vec3(0, 1, 11)).norm(), 1e-12) << "as long, and turned";
  EXPECT_EQ(matrix.row(3), Eigen::RowVector4d(0, 0, 0, 1));
}

TEST(HandleMatrices, OfACurveFitItsVertices) {
  const Eigen::Matrix4d matrix = matrix_of_tip(
      "    select: {path: [[0, 0, 8], [2, 0, 8]]}\n"
      "    curve: {keys: {0s: rest, 1s: {polyline: [[5, 0, 8], [5, 2, 8]]}}}\n");
  EXPECT_LT((apply(matrix, {0, 0, 8}) - Vec3(5, 0, 8)).norm(), 1e-12);
  EXPECT_LT((apply(matrix, {2, 0, 8}) - Vec3(5, 2, 8)).norm(), 1e-12);
  EXPECT_LT((apply(matrix, {0, 0, 9}) - Vec3(5, 0, 9)).norm(), 1e-12) << "turned no further than it must";
}

}  // namespace
}  // namespace flexkey
