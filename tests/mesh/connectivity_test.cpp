#include "flexkey/mesh/connectivity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/meshes.h"

namespace flexkey {
namespace {

TEST(Connectivity, EdgesCountTheirFacesBothWays) {
  const Mesh mesh = meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}});
  const std::vector<MeshEdge> edges = mesh_edges(mesh);
  ASSERT_EQ(edges.size(), 5u);
  const MeshEdge shared = edges[2];
  EXPECT_EQ(shared.low, 1);
  EXPECT_EQ(shared.high, 2);
  EXPECT_EQ(shared.forward, 1);
  EXPECT_EQ(shared.backward, 1);
}

TEST(Connectivity, NeighboursAreAlongEdgesNotDiagonals) {
  const Mesh mesh = meshes::grid(2, 2);
  const Neighbours neighbours(mesh_edges(mesh), mesh.vertex_count());
  EXPECT_THAT(neighbours.of(4), testing::ElementsAre(1, 3, 5, 7));
  EXPECT_THAT(neighbours.of(0), testing::ElementsAre(1, 3));
}

TEST(Connectivity, ComponentsAreNumberedByTheirLowestVertex) {
  const Mesh mesh = meshes::make_mesh(std::vector<Vec3>(8, Vec3::Zero()), {{5, 6, 7}, {1, 2, 3}});
  const Components components = find_components(mesh);
  EXPECT_EQ(components.count, 2);
  EXPECT_THAT(components.of_vertex, testing::ElementsAre(-1, 0, 0, 0, -1, 1, 1, 1));
}

TEST(Connectivity, BoundaryLoopsComeLongestFirst) {
  Mesh mesh = meshes::grid(3, 3);  // with its middle face taken out
  Mesh ring;
  ring.positions = mesh.positions;
  for (int f = 0; f < mesh.face_count(); ++f)
    if (f != 4) ring.add_face(mesh.face(f));
  const auto loops = boundary_loops(ring);
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[0].size(), 12u);
  EXPECT_THAT(loops[1], testing::UnorderedElementsAre(5, 6, 9, 10));
}

}  // namespace
}  // namespace flexkey
