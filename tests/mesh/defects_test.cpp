#include "flexkey/mesh/defects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/meshes.h"

namespace flexkey {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Defects, ACleanMeshHasNone) {
  EXPECT_TRUE(find_defects(meshes::grid(4, 4)).none());
  EXPECT_TRUE(describe(find_defects(meshes::grid(4, 4))).empty());
}

TEST(Defects, NamesDegenerateFaces) {
  const Mesh mesh =
      meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 0, 3}, {0, 2, 3}});
  EXPECT_THAT(find_defects(mesh).degenerate_faces, ElementsAre(0, 1));
  EXPECT_EQ(describe(find_defects(mesh)).front(), "2 degenerate faces (0, 1)");
}

TEST(Defects, ASliverIsNotDegenerate) {
  const Mesh mesh = meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-7, 0}}, {{0, 1, 2}});
  EXPECT_TRUE(find_defects(mesh).degenerate_faces.empty());
}

TEST(Defects, NamesDuplicateFacesInWhateverOrder) {
  const Mesh mesh = meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {1, 0, 2}});
  EXPECT_THAT(find_defects(mesh).duplicate_faces, ElementsAre(1));
}

TEST(Defects, NamesNonManifoldAndFlippedEdges) {
  const Mesh mesh = meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                                      {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_THAT(find_defects(mesh).non_manifold_edges, ElementsAre(Edge(0, 1)));
  const Mesh flipped =
      meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 1, 3}});
  EXPECT_THAT(find_defects(flipped).flipped_edges, ElementsAre(Edge(0, 1)));
  EXPECT_THAT(describe(find_defects(flipped)).front(), HasSubstr("1 flipped edge (0-1)"));
}

TEST(Defects, NamesUnreferencedVerticesAndCutsLongLists) {
  Mesh mesh = meshes::make_mesh(std::vector<Vec3>(9, Vec3(5, 5, 5)), {});
  mesh.positions.row(0) = Vec3(0, 0, 0).transpose();
  mesh.positions.row(1) = Vec3(1, 0, 0).transpose();
  mesh.positions.row(2) = Vec3(0, 1, 0).transpose();
  mesh.add_face(std::vector<int>{0, 1, 2});
  EXPECT_EQ(describe(find_defects(mesh)).front(), "6 unreferenced vertices (3, 4, 5, 6, 7, …)");
}

}  // namespace
}  // namespace flexkey
