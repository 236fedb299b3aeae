#include "flexkey/mesh/mesh.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace flexkey {
namespace {

TEST(Mesh, KeepsPolygonsAsTheyWereAdded) {
  const Mesh mesh =
      meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2, 3}, {1, 4, 2}});
  ASSERT_EQ(mesh.face_count(), 2);
  EXPECT_EQ(mesh.face(0).size(), 4u);
  EXPECT_EQ(mesh.face(1)[1], 4);
  EXPECT_EQ(Mesh().face_count(), 0);
}

TEST(Mesh, BoundsSpanAllVertices) {
  const Mesh mesh = meshes::grid(3, 3);
  EXPECT_EQ(bounds_of(mesh.positions).min, Vec3(0, 0, 0));
  EXPECT_EQ(bounds_of(mesh.positions).max, Vec3(3, 3, 0));
  EXPECT_EQ(bounds_of(Positions(0, 3)).diagonal(), 0);
}

TEST(Mesh, NormalsDoNotDependOnWhichCornerComesFirst) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0.3}, {1, 1, 0}, {0, 1, -0.2}};
  const Mesh mesh = meshes::make_mesh(points, {{0, 1, 2, 3}}),
             turned = meshes::make_mesh(points, {{2, 3, 0, 1}});
  EXPECT_LT((vertex_normals(mesh, mesh.positions) - vertex_normals(turned, turned.positions)).norm(), 1e-15);
  EXPECT_GT(vertex_normals(mesh, mesh.positions)(0, 2), 0.9);
}

TEST(Mesh, ALargeFaceOutweighsASmallOne) {
  const Mesh mesh =
      meshes::make_mesh({{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 0.1}}, {{0, 1, 2}, {0, 3, 1}});
  const Positions normals = vertex_normals(mesh, mesh.positions);
  EXPECT_GT(normals(0, 2), 0.99);
}

TEST(Mesh, AVertexWithoutAreaStillHasAUnitNormal) {
  const Mesh mesh = meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  EXPECT_EQ(vertex_normals(mesh, mesh.positions).row(0).transpose(), Vec3(0, 1, 0));
}

}  // namespace
}  // namespace flexkey
