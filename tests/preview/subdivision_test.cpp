#include "flexkey/preview/subdivision.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <set>

#include "flexkey/mesh/error.h"
#include "flexkey/preview/normals.h"
#include "preview/surfaces.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

using Eigen::RowVector3f;
using Eigen::Vector3f;

constexpr float kClose = 1e-6f;

bool has_point(const Points& points, const RowVector3f& p) {
  return (points.rowwise() - p).rowwise().norm().minCoeff() < kClose;
}

RowVector3f moved_vertex(const Subdivision& subdivision, const Points& points, std::size_t vertex) {
  return points.row(subdivision.surface().of_vertex[vertex]);
}

TEST(Subdivision, LevelZeroIsTheMeshInTriangles) {
  const Mesh cube = meshes::cube();
  const Subdivision subdivision(cube, 0);
  EXPECT_EQ(subdivision.surface().triangles.size(), 12u);
  EXPECT_EQ(subdivision.surface().wires.size(), 12u);
  const Points points = refined_points(subdivision, cube.positions);
  for (std::size_t v = 0; v < 8; ++v) {
    const RowVector3f expected = cube.positions.row(static_cast<Eigen::Index>(v)).cast<float>();
    EXPECT_EQ(moved_vertex(subdivision, points, v), expected);
  }
}

// Catmull and Clark 1978: a face's point is its mean; an edge's the mean of its ends and its faces' points; a
// vertex of valence n goes to (F + 2 E + (n - 3) v) / n, with the means of face points and edge middles.
TEST(Subdivision, FollowsTheCatmullClarkRuleOnACube) {
  const Mesh cube = meshes::cube();
  const Subdivision subdivision(cube, 1);
  const Points points = refined_points(subdivision, cube.positions);
  ASSERT_EQ(points.rows(), 8 + 12 + 6);
  EXPECT_TRUE(has_point(points, {0.5f, 0.5f, 0.0f}));      // of a face
  EXPECT_TRUE(has_point(points, {0.5f, 0.125f, 0.125f}));  // of an edge: (0 + 0 + 0 + 0.5) / 4 both ways
  EXPECT_TRUE(
      has_point(points, RowVector3f::Constant(2.0f / 9)));  // of the corner at the origin: F = 1/3, E = 1/6
}

TEST(Subdivision, FollowsTheCatmullClarkRuleInsideAGrid) {
  Mesh grid = meshes::grid(4, 4);
  grid.positions(12, 2) = 64;  // the vertex in the middle, (2, 2)
  const Subdivision subdivision(grid, 1);
  const Points points = refined_points(subdivision, grid.positions);
  EXPECT_TRUE(has_point(points, {1.5f, 1.5f, 16}));  // a quarter
  EXPECT_TRUE(has_point(points, {1.5f, 2, 24}));     // 3/8
  EXPECT_TRUE(has_point(points, {2, 2, 36}));        // 9/16
  EXPECT_TRUE(has_point(points, {1, 2, 6}));         // 3/32, the neighbour along an edge
  EXPECT_TRUE(has_point(points, {1, 1, 1}));         // 1/64, the one across a face
}

// Loop 1987: an edge's point is 3/8 of its ends and 1/8 of the corners across; a vertex of valence six keeps
// 5/8 and takes 1/16 of each neighbour.
TEST(Subdivision, FollowsTheLoopRuleOnTriangles) {
  Mesh grid = meshes::triangulated(meshes::grid(4, 4));
  grid.positions(12, 2) = 16;
  const Subdivision subdivision(grid, 1);
  const Points points = refined_points(subdivision, grid.positions);
  EXPECT_EQ(subdivision.surface().triangles.size(), 4u * 32u);
  EXPECT_TRUE(has_point(points, {2, 2, 10}));
  EXPECT_TRUE(has_point(points, {1.5f, 2, 6}));
  EXPECT_TRUE(has_point(points, {1.5f, 1.5f, 6}));  // along the diagonal
  EXPECT_TRUE(has_point(points, {1.5f, 2.5f, 2}));  // of an edge that faces the vertex
  EXPECT_TRUE(has_point(points, {1, 2, 1}));
}

// Halstead, Kass and DeRose 1993: the limit of a vertex is (n^2 v + 4 sum of edge points + sum of face
// points) / (n (n + 5)) of any level's neighbours; at the cube's corner a sixth of the way in... by level 0
// itself.
TEST(Subdivision, ConvergesToTheLimitOfACubesCorner) {
  const Mesh cube = meshes::cube();
  // n = 3; 4 times the neighbours at distance one (sum 1 a coordinate), once those across (sum 2).
  const double limit = (9 * 0.0 + 4 * 1.0 + 1 * 2.0) / (3 * 8);
  const auto corner = [&](int level) {
    const Subdivision subdivision(cube, level);
    return static_cast<double>(moved_vertex(subdivision, refined_points(subdivision, cube.positions), 0).x());
  };
  EXPECT_NEAR(corner(4), limit, 1e-3);
  EXPECT_LT(std::abs(corner(4) - limit), 0.3 * std::abs(corner(3) - limit));
}

TEST(Subdivision, KeepsBordersAndTheirCorners) {
  const Mesh grid = meshes::grid(3, 2);
  const Subdivision subdivision(grid, 2);
  const Points points = refined_points(subdivision, grid.positions);
  const RowVector3f low(0, 0, 0), high(3, 2, 0);
  EXPECT_LT((points.colwise().minCoeff() - low).norm(), kClose);
  EXPECT_LT((points.colwise().maxCoeff() - high).norm(), kClose);
  EXPECT_TRUE(has_point(points, low));
  EXPECT_TRUE(has_point(points, high));
  EXPECT_EQ(subdivision.surface().triangles.size(), 2u * 6u * 16u);
}

// A border is a cubic B-spline: 1/8, 6/8, 1/8.
TEST(Subdivision, BordersAreSplinesOfTheirOwn) {
  Mesh grid = meshes::grid(4, 3);
  grid.positions(2, 1) = -8;  // the middle of the lower border
  const Subdivision subdivision(grid, 1);
  EXPECT_TRUE(has_point(refined_points(subdivision, grid.positions), {2, -6, 0}));
  EXPECT_TRUE(has_point(refined_points(subdivision, grid.positions), {1, -1, 0}));
}

TEST(Subdivision, PointsFollowAnyAffineMotion) {
  const Mesh mesh = meshes::bumpy(meshes::bar(2, 3, 4), 0.1);
  const Subdivision subdivision(mesh, 2);
  const Eigen::Matrix3d turn = meshes::turn(40, {1, 2, 3});
  const Points moved = refined_points(subdivision, meshes::moved(mesh.positions, turn, {5, 6, 7}));
  const Points rest = refined_points(subdivision, mesh.positions);
  const Points expected = (rest * turn.cast<float>().transpose()).rowwise() + RowVector3f(5, 6, 7);
  EXPECT_LT((moved - expected).cwiseAbs().maxCoeff(), 1e-4f);
}

TEST(Subdivision, ClosesSeamsInSpaceAndKeepsThemInTexture) {
  // Two quads side by side whose common edge has two places in the texture and two vertices a place.
  Mesh mesh = meshes::make_mesh(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}},
      {{0, 1, 2, 3}, {4, 5, 6, 7}});
  mesh.texcoords.resize(8, 2);
  mesh.texcoords << 0, 0, 0.4, 0, 0.4, 1, 0, 1, 0.6, 0, 1, 0, 1, 1, 0.6, 1;
  mesh.corner_texcoord = {0, 1, 2, 3, 4, 5, 6, 7};
  const Subdivision subdivision(mesh, 1);
  const Surface& surface = subdivision.surface();
  EXPECT_EQ(surface.vertex_count, 3 * 5);
  EXPECT_EQ(surface.of_vertex[1], surface.of_vertex[4]);
  ASSERT_EQ(surface.texcoords.size(), surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (const Eigen::Vector2f& uv : surface.texcoords[t]) {
      EXPECT_TRUE(surface.face_of[t] == 0 ? uv.x() <= 0.4f + kClose : uv.x() >= 0.6f - kClose)
          << uv.transpose();
    }
  }
}

TEST(Subdivision, WiresLieOnTheControlEdgesOnly) {
  const Mesh grid = meshes::grid(2, 2);
  const Subdivision subdivision(grid, 2);
  const Points points = refined_points(subdivision, grid.positions);
  EXPECT_EQ(subdivision.surface().wires.size(), 12u * 4u);
  for (const auto& [a, b] : subdivision.surface().wires) {
    const RowVector3f middle = (points.row(a) + points.row(b)) / 2;
    const float off_x = std::abs(middle.x() - std::round(middle.x()));
    const float off_y = std::abs(middle.y() - std::round(middle.y()));
    EXPECT_LT(std::min(off_x, off_y), kClose) << middle;
  }
}

TEST(Subdivision, MixesPolygonsOfAnyCornerCount) {
  const Mesh prism = meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
                                       {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}});
  const Subdivision subdivision(prism, 2);
  EXPECT_EQ(subdivision.surface().triangles.size(), 2u * 18u * 4u);
  EXPECT_EQ(std::set<int>(subdivision.surface().face_of.begin(), subdivision.surface().face_of.end()).size(),
            5u);
}

TEST(Subdivision, RefusesOtherLevelsAndMoreTrianglesThanFit) {
  EXPECT_THROW(Subdivision(meshes::cube(), -1), InputError);
  EXPECT_THROW(Subdivision(meshes::cube(), 5), InputError);
  EXPECT_THROW(Subdivision(meshes::grid(320, 320), 4), InputError);
}

TEST(Normals, OfASphereAreItsRadii) {
  const Mesh sphere = meshes::sphere(3);
  const Subdivision subdivision(sphere, 1);
  const Points points = refined_points(subdivision, sphere.positions);
  const Points normals = Normals(subdivision.surface()).at(points);
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    EXPECT_GT(normals.row(v).dot(points.row(v).normalized()), 0.999f);
    EXPECT_NEAR(normals.row(v).norm(), 1, 1e-5);
  }
}

}  // namespace
}  // namespace flexkey
