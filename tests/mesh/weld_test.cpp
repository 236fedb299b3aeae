#include "flexkey/mesh/weld.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "flexkey/mesh/connectivity.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

// Two quads that meet along an edge whose vertices are doubled, as a UV seam doubles them.
Mesh split_pair(double gap = 0) {
  return meshes::make_mesh(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1 + gap, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1 + gap, 1, 0}},
      {{0, 1, 2, 3}, {4, 5, 6, 7}});
}

TEST(Weld, JoinsVerticesAtOnePlace) {
  const Weld welded = weld(split_pair());
  EXPECT_EQ(welded.surface.vertex_count(), 6);
  EXPECT_THAT(welded.to_surface, testing::ElementsAre(0, 1, 2, 3, 1, 4, 5, 2));
  EXPECT_EQ(find_components(welded.surface).count, 1);
  EXPECT_EQ(find_components(split_pair()).count, 2);
}

TEST(Weld, ScatterGivesBothSidesOfASeamTheSamePlace) {
  const Mesh mesh = split_pair();
  const Weld welded = weld(mesh);
  EXPECT_EQ(scatter(welded, welded.surface.positions), mesh.positions);
  Positions moved = welded.surface.positions;
  moved.row(1) += Vec3(0, 0, 5).transpose();
  const Positions scattered = scatter(welded, moved);
  EXPECT_EQ(scattered.row(1), scattered.row(4));
}

TEST(Weld, ADistanceClosesSmallGapsOnly) {
  EXPECT_EQ(weld(split_pair(1e-4)).surface.vertex_count(), 8);
  EXPECT_EQ(weld(split_pair(1e-4), 1e-3).surface.vertex_count(), 6);
  EXPECT_EQ(weld(split_pair(1e-2), 1e-3).surface.vertex_count(), 8);
}

TEST(Weld, TakesMinusZeroForZero) {
  Mesh mesh = split_pair();
  mesh.positions(4, 2) = -0.0;
  EXPECT_EQ(weld(mesh).surface.vertex_count(), 6);
}

TEST(Weld, KeepsFacesAndGroups) {
  Mesh mesh = split_pair();
  mesh.groups = {{"right", {1}}};
  const Weld welded = weld(mesh);
  EXPECT_EQ(welded.surface.face_offsets, mesh.face_offsets);
  EXPECT_EQ(welded.surface.groups[0].faces, mesh.groups[0].faces);
}

}  // namespace
}  // namespace flexkey
