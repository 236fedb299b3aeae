#include "flexkey/mesh/geodesic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/meshes.h"

namespace flexkey {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

TEST(Geodesic, NearestVertexIsTheLowestOfSeveral) {
  EXPECT_EQ(nearest_vertex(meshes::grid(2, 2).positions, {0.5, 0.5, 3}), 0);
  EXPECT_EQ(nearest_vertex(meshes::grid(2, 2).positions, {1.9, 2.2, 0}), 8);
}

TEST(Geodesic, ShortestPathFollowsEdges) {
  const Mesh mesh = meshes::grid(4, 4);
  const Neighbours neighbours(mesh_edges(mesh), mesh.vertex_count());
  EXPECT_THAT(shortest_path(mesh, neighbours, 0, 4), testing::ElementsAre(0, 1, 2, 3, 4));
  EXPECT_EQ(shortest_path(mesh, neighbours, 0, 24).size(), 9u);  // no short cut over the quads' diagonals
  EXPECT_THAT(shortest_path(mesh, neighbours, 7, 7), testing::ElementsAre(7));
}

TEST(Geodesic, NoPathLeadsToAnotherComponent) {
  const Mesh mesh = meshes::make_mesh(std::vector<Vec3>(6, Vec3::Zero()), {{0, 1, 2}, {3, 4, 5}});
  const Neighbours neighbours(mesh_edges(mesh), mesh.vertex_count());
  EXPECT_TRUE(shortest_path(mesh, neighbours, 0, 5).empty());
  EXPECT_TRUE(std::isinf(geodesic_distances(mesh, {0}, no_limit)[5]));
}

TEST(Geodesic, OnAPlaneItIsTheStraightLine) {
  const int n = 40;
  const Mesh mesh = meshes::grid(n, n);
  const int source = n / 2 + (n + 1) * (n / 2);
  const std::vector<double> distance = geodesic_distances(mesh, {source}, no_limit);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const double straight = (mesh.positions.row(v) - mesh.positions.row(source)).norm();
    EXPECT_NEAR(distance[static_cast<std::size_t>(v)], straight, 0.03 * straight + 1e-12) << "vertex " << v;
    EXPECT_GE(distance[static_cast<std::size_t>(v)], straight - 1e-9);
  }
}

TEST(Geodesic, FromAStraightEdgeItIsTheDistanceToIt) {
  const int n = 12;
  const Mesh mesh = meshes::grid(n, n);
  std::vector<int> edge;
  for (int v = 0; v <= n; ++v) edge.push_back(v);
  const std::vector<double> distance = geodesic_distances(mesh, edge, no_limit);
  for (int v = 0; v < mesh.vertex_count(); ++v)
    EXPECT_NEAR(distance[static_cast<std::size_t>(v)], mesh.positions(v, 1), 1e-12) << "vertex " << v;
}

TEST(Geodesic, FromADiscItIsTheDistanceToIt) {
  const int n = 60;
  const Mesh mesh = meshes::grid(n, n);
  const Vec3 centre(n / 2.0, n / 2.0, 0);
  std::vector<int> disc;
  const auto radius = [&](int v) { return (mesh.positions.row(v).transpose() - centre).norm(); };
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if (radius(v) <= 10) disc.push_back(v);
  const std::vector<double> distance = geodesic_distances(mesh, disc, no_limit);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (radius(v) < 12) continue;
    EXPECT_NEAR(distance[static_cast<std::size_t>(v)], radius(v) - 10, 0.5 + 0.03 * radius(v))
        << "vertex " << v;
  }
}

TEST(Geodesic, GoesOverAFoldAndNotThroughTheAir) {
  // A strip of quads bent into a U: its ends are near in space and far along the surface.
  std::vector<Vec3> points;
  std::vector<std::vector<int>> faces;
  const int n = 60;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j < 2; ++j) {
      const double angle = M_PI * i / n;
      points.emplace_back(std::cos(angle), j * 0.2, std::sin(angle));
    }
  for (int i = 0; i < n; ++i) faces.push_back({2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2});
  const Mesh mesh = meshes::make_mesh(points, faces);
  EXPECT_NEAR(geodesic_distances(mesh, {0}, no_limit)[static_cast<std::size_t>(2 * n)], M_PI, 1e-3);
}

}  // namespace
}  // namespace flexkey
