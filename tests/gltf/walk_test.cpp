#include "flexkey/gltf/walk.h"

#include <gmock/gmock.h>

namespace flexkey {
namespace {

using ::testing::ElementsAre;

/// One vertex that is at these points in the plane.
ShapeRows shapes(const std::vector<Eigen::Vector2d>& points) {
  ShapeRows rows = ShapeRows::Zero(std::ssize(points), 3);
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    rows.row(k).head(2) = points[static_cast<std::size_t>(k)].transpose();
  }
  return rows;
}

std::vector<int> nodes_of(const Walk& walk) {
  std::vector<int> nodes;
  for (const Visit& visit : walk.visits) nodes.push_back(visit.node);
  return nodes;
}

TEST(Walk, TurnsWhereTheMotionTurns) {
  const Walk walk = walk_along(shapes({{0, 0}, {1, 0}, {4, 0}, {4, 1}, {4, 2}}), 0.01);
  EXPECT_THAT(walk.origin, ElementsAre(-1, 2, 4));
  EXPECT_THAT(nodes_of(walk), ElementsAre(kRestNode, 1, 2));
}

TEST(Walk, MeetsItsNodesBetweenFramesOnTheWayBack) {
  const Walk walk = walk_along(shapes({{0, 0}, {4, 0}, {4, 2}, {4, 0.3}, {3.7, 0}, {1, 0}, {0, 0}}), 0.25);
  EXPECT_THAT(walk.origin, ElementsAre(-1, 1, 2));
  EXPECT_THAT(nodes_of(walk), ElementsAre(kRestNode, 1, 2, 1, kRestNode));
  EXPECT_DOUBLE_EQ(walk.visits[3].frame, 3.5);
  EXPECT_TRUE(walk.visits[3].is_between_frames());
}

TEST(Walk, TurnsBackOnItsWay) {
  const Walk walk = walk_along(shapes({{0, 0}, {4, 0}, {4, 3}, {4, 1}, {4, 3}, {8, 3}}), 0.01);
  EXPECT_THAT(walk.origin, ElementsAre(-1, 1, 2, 5));
  EXPECT_THAT(nodes_of(walk), ElementsAre(kRestNode, 1, 2, 2, 3));
  EXPECT_EQ(walk.visits[3].towards, 1);
}

TEST(Walk, BeginsAwayFromRest) {
  const Walk walk = walk_along(shapes({{1, 1}, {2, 1}, {3, 1}}), 0.01);
  EXPECT_THAT(walk.origin, ElementsAre(-1, 0, 2));
  EXPECT_THAT(nodes_of(walk), ElementsAre(1, 2));
}

TEST(Walk, FindsTheNearestPlaceOfAWay) {
  const ShapeRows rows = shapes({{1, 5}, {0, 0}, {4, 0}, {-1, 0}, {7, 0}});
  EXPECT_DOUBLE_EQ(share_of_way(rows.row(0), rows.row(1), rows.row(2)), 0.25);
  EXPECT_EQ(share_of_way(rows.row(3), rows.row(1), rows.row(2)), 0);
  EXPECT_EQ(share_of_way(rows.row(4), rows.row(1), rows.row(2)), 1);
  EXPECT_EQ(share_of_way(rows.row(4), rows.row(1), rows.row(1)), 0);
}

}  // namespace
}  // namespace flexkey
