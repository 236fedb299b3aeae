#include "flexkey/gltf/split_faces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "flexkey/gltf/moved_vertices.h"

namespace flexkey::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(SplitFaces, ATriangleMovesWithAnyOfItsCorners) {
  const std::vector<std::uint32_t> corners = {4, 2, 1, 1, 2, 0, 4, 5, 2};
  const SplitFaces faces = split_faces(corners, {true, false, false, false, false, false});
  EXPECT_THAT(faces.moving.triangles, ElementsAre(1));
  EXPECT_THAT(faces.moving.vertices, ElementsAre(0, 1, 2));
  EXPECT_THAT(faces.moving.corners, ElementsAre(1, 2, 0));
  EXPECT_THAT(faces.still.triangles, ElementsAre(0, 2));
  EXPECT_THAT(faces.still.vertices, ElementsAre(1, 2, 4, 5)) << "3 is in no face";
  EXPECT_THAT(faces.still.corners, ElementsAre(2, 1, 0, 2, 3, 1));
}

TEST(SplitFaces, ASideMayBeEmpty) {
  const std::vector<std::uint32_t> corners = {0, 1, 2};
  EXPECT_THAT(split_faces(corners, {false, false, false}).moving.vertices, IsEmpty());
  EXPECT_THAT(split_faces(corners, {false, false, true}).still.triangles, IsEmpty());
}

FloatRows one_row(Eigen::Index row) {
  FloatRows rows = FloatRows::Zero(4, 3);
  rows(row, 2) = 1e-20F;
  return rows;
}

TEST(MovedVertices, MoveOrTurnInAnyTarget) {
  EXPECT_THAT(moved_vertices(MorphTargets{{one_row(0), one_row(2)}, {one_row(2), one_row(3)}}),
              ElementsAre(true, false, true, true));
  QuantizedTargets quantized;
  quantized.positions = {ShortRows::Zero(4, 3)};
  quantized.positions[0](1, 0) = -1;
  quantized.float_normals = {one_row(3)};
  EXPECT_THAT(moved_vertices(quantized), ElementsAre(false, true, false, true));
}

}  // namespace
}  // namespace flexkey::testing
