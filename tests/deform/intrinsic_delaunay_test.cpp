#include "flexkey/deform/intrinsic_delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "flexkey/deform/polygon_cut.h"
#include "flexkey/deform/weights.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

using Edge = std::pair<int, int>;

Eigen::MatrixXd dense_weights(const Mesh& mesh, Weights weights) {
  const Cells cells = build_cells(mesh, weights);
  Eigen::MatrixXd W = Eigen::MatrixXd::Zero(cells.count(), cells.count());
  for (int i = 0; i < cells.count(); ++i) {
    for (const auto [j, weight] : cells.of(i)) W(i, j) = weight;
  }
  return W;
}

/// A flat strip of triangles as obtuse as `slant` is large: a grid whose rows are pushed along x.
Mesh slanted(double slant) {
  Mesh mesh = meshes::triangulated(meshes::grid(8, 5));
  mesh.positions.col(0) += slant * mesh.positions.col(1);
  return mesh;
}

double area(const std::vector<IntrinsicTriangle>& triangles) {
  double sum = 0;
  for (const IntrinsicTriangle& triangle : triangles) sum += double_area(triangle.lengths) / 2;
  return sum;
}

TEST(DoubleArea, OfARightTriangleAndOfNone) {
  EXPECT_NEAR(double_area({3, 4, 5}), 12, 1e-14);
  EXPECT_NEAR(double_area({1, 1e-9, 1}), 1e-9, 1e-17);
  EXPECT_EQ(double_area({1, 2, 3}), 0);
  EXPECT_EQ(double_area({1, 1, 3}), 0);
}

TEST(PolygonCut, TakesTheShorterDiagonalWhereverTheFaceBegins) {
  const Mesh kite = meshes::make_mesh({{0, 0, 0}, {3, -1, 0}, {6, 0, 0}, {3, 1, 0}}, {{0, 1, 2, 3}});
  std::vector<int> face{0, 1, 2, 3};
  for (int k = 0; k < 4; ++k) {
    const auto triangles = cut_polygon(kite.positions, face);
    ASSERT_EQ(triangles.size(), 2u);
    for (const auto& t : triangles)
      EXPECT_EQ(std::count(t.begin(), t.end(), 1) + std::count(t.begin(), t.end(), 3), 2);
    std::rotate(face.begin(), face.begin() + 1, face.end());
  }
}

TEST(PolygonCut, CoversAPolygonAndLeavesRepeatedCornersOut) {
  Positions ring(40, 3);
  std::vector<int> face;
  for (int k = 0; k < 40; ++k) {
    const double angle = 2 * std::numbers::pi * k / 40;
    ring.row(k) << std::cos(angle), 2 * std::sin(angle), 0;
    face.push_back(k);
  }
  double covered = 0;
  for (const auto& [a, b, c] : cut_polygon(ring, face)) {
    const Vec3 ab = ring.row(b) - ring.row(a), ac = ring.row(c) - ring.row(a);
    EXPECT_GT(ab.cross(ac).z(), 0);
    covered += ab.cross(ac).z() / 2;
  }
  EXPECT_NEAR(covered, 40 * std::sin(2 * std::numbers::pi / 40), 1e-12);
  EXPECT_EQ(cut_polygon(ring, std::vector<int>{3, 4, 5, 5}).size(), 1u);
  EXPECT_TRUE(cut_polygon(ring, std::vector<int>{3, 4, 4}).empty());
  EXPECT_TRUE(cut_polygon(ring, std::vector<int>{3, 4}).empty());
}

TEST(IntrinsicDelaunay, FlipsAFlatStripToThePlanesOwn) {
  for (const double slant : {1.0, 3.0, 7.0}) {
    const Mesh mesh = slanted(slant);
    const auto triangles = intrinsic_delaunay(mesh);
    EXPECT_NEAR(area(triangles), 40, 1e-9);
    for (const auto& [corners, lengths] : triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double straight =
            (mesh.positions.row(corners[(k + 1) % 3]) - mesh.positions.row(corners[(k + 2) % 3])).norm();
        EXPECT_NEAR(lengths[k], straight, 1e-9);
      }
      // No vertex lies within a triangle's circle.
      const double radius = lengths[0] * lengths[1] * lengths[2] / (2 * double_area(lengths));
      Eigen::Matrix2d sides;
      const Eigen::Vector2d a = mesh.positions.row(corners[0]).head<2>();
      sides << mesh.positions.row(corners[1]).head<2>() - a.transpose(),
          mesh.positions.row(corners[2]).head<2>() - a.transpose();
      const Eigen::Vector2d center = a + sides.inverse() * sides.rowwise().squaredNorm() / 2;
      for (int v = 0; v < mesh.vertex_count(); ++v)
        EXPECT_GT((mesh.positions.row(v).head<2>().transpose() - center).norm(), radius * (1 - 1e-9));
    }
  }
}

TEST(IntrinsicDelaunay, LeavesNoNegativeWeightOnAClosedObtuseSurface) {
  Mesh mesh = meshes::bumpy(meshes::sphere(3), 0.1);
  mesh.positions.col(0) *= 6;
  const auto before = dense_weights(mesh, Weights::cotangent);
  ASSERT_LT(before.minCoeff(), -0.1);
  const std::vector<WeightedTriangle> triangles = cotangent_triangles(mesh, Weights::intrinsic_delaunay);
  std::map<Edge, double> sums;
  for (const auto& [corners, weights, share] : triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      sums[std::minmax(corners[(k + 1) % 3], corners[(k + 2) % 3])] += weights[k];
  }
  for (const auto& [edge, weight] : sums) EXPECT_GT(weight, -1e-8);
  EXPECT_EQ(triangles.size(), static_cast<std::size_t>(mesh.face_count()));
}

TEST(IntrinsicDelaunay, OfADelaunaySurfaceIsTheSurface) {
  const Mesh mesh = meshes::sphere(3);
  const Eigen::MatrixXd clamped = dense_weights(mesh, Weights::clamped);
  EXPECT_LT((dense_weights(mesh, Weights::intrinsic_delaunay) - clamped).norm(), 1e-11 * clamped.norm());
}

TEST(IntrinsicDelaunay, LengthsOfFlippedEdgesGoAlongTheSurface) {
  // Two obtuse triangles, folded by a right angle at their common edge from vertex 0 to vertex 1.
  const Mesh roof = meshes::make_mesh({{0, 0, 0}, {6, 0, 0}, {3, 1, 0}, {3, 0, -1}}, {{0, 1, 2}, {1, 0, 3}});
  const auto triangles = intrinsic_delaunay(roof);
  ASSERT_EQ(triangles.size(), 2u);
  for (const auto& [corners, lengths] : triangles) {
    EXPECT_EQ(std::count(corners.begin(), corners.end(), 2) + std::count(corners.begin(), corners.end(), 3),
              2);
    EXPECT_NEAR(*std::min_element(lengths.begin(), lengths.end()), 2, 1e-12);  // unfolded; √2 through space
  }
}

TEST(IntrinsicDelaunay, DoesNotDependOnTheOrderOfVerticesAndCorners) {
  Mesh mesh = meshes::bumpy(meshes::bar(6, 3, 2), 0.2);
  mesh.positions.col(0) *= 3;
  std::vector<int> new_index(mesh.vertex_count());
  std::iota(new_index.begin(), new_index.end(), 0);
  std::shuffle(new_index.begin(), new_index.end(), std::mt19937(3));
  Mesh shuffled;
  shuffled.positions.resize(mesh.positions.rows(), 3);
  for (int v = 0; v < mesh.vertex_count(); ++v) shuffled.positions.row(new_index[v]) = mesh.positions.row(v);
  for (int f = mesh.face_count() - 1; f >= 0; --f) {
    std::vector<int> face(mesh.face(f).begin(), mesh.face(f).end());
    for (int& v : face) v = new_index[v];
    std::rotate(face.begin(), face.begin() + f % 4, face.end());
    shuffled.add_face(face);
  }
  const Eigen::MatrixXd W = dense_weights(mesh, Weights::intrinsic_delaunay);
  const Eigen::MatrixXd other = dense_weights(shuffled, Weights::intrinsic_delaunay);
  EXPECT_LT((other(new_index, new_index) - W).norm(), 1e-10 * W.norm());
}

TEST(IntrinsicDelaunay, KeepsWhatItCannotFlip) {
  // Three obtuse triangles at one edge, and two that both go the same way along theirs.
  const Mesh book = meshes::make_mesh({{0, 0, 0}, {6, 0, 0}, {3, 1, 0}, {3, 0, 1}, {3, -1, 0}},
                                      {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}});
  const Mesh twisted =
      meshes::make_mesh({{0, 0, 0}, {6, 0, 0}, {3, 1, 0}, {3, -1, 0}}, {{0, 1, 2}, {0, 1, 3}});
  for (const Mesh& mesh : {book, twisted}) {
    EXPECT_GT(dense_weights(mesh, Weights::intrinsic_delaunay)(0, 1), 0);
    for (const auto& [corners, lengths] : intrinsic_delaunay(mesh)) {
      EXPECT_EQ(std::count(corners.begin(), corners.end(), 0), 1);
      EXPECT_EQ(std::count(corners.begin(), corners.end(), 1), 1);
    }
  }
}

TEST(IntrinsicDelaunay, SumsEdgesThatJoinTheSameVertices) {
  // A flat pillow whose three corners are joined to themselves through both sides, and a needle.
  Mesh pillow = meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {0.5, 0.2, 0}}, {{0, 1, 2}, {1, 0, 2}});
  Mesh needle = meshes::make_mesh({{0, 0, 0}, {1, 0.1, 0}, {1, -0.05, 0.1}, {1, -0.05, -0.1}, {9, 0, 0}},
                                  {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {4, 2, 1}, {4, 3, 2}, {4, 1, 3}});
  for (const Mesh& mesh : {pillow, needle}) {
    for (const auto& [corners, lengths] : intrinsic_delaunay(mesh)) {
      EXPECT_TRUE(corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]);
    }
    const Eigen::MatrixXd W = dense_weights(mesh, Weights::intrinsic_delaunay);
    EXPECT_TRUE(W.allFinite());
    EXPECT_GE(W.minCoeff(), 0);
  }
}

TEST(IntrinsicDelaunay, EndsOnDegenerateSurfaces) {
  Mesh point = meshes::bar(4, 2, 2);
  point.positions.setZero();
  Mesh line = meshes::bar(4, 2, 2);
  line.positions.rightCols<2>().setZero();
  Mesh slivers = meshes::triangulated(meshes::bar(6, 3, 3));
  slivers.positions.col(0) *= 1e-9;
  Mesh pinched = meshes::bumpy(meshes::sphere(2), 0.1);
  pinched.positions.row(3) = pinched.positions.row(20);
  for (const int v : {30, 31, 32}) pinched.positions.row(v) = pinched.positions.row(33);
  for (const Mesh& mesh : {point, line, slivers, pinched, meshes::make_mesh({}, {})}) {
    EXPECT_TRUE(dense_weights(mesh, Weights::intrinsic_delaunay).allFinite());
  }
}

}  // namespace
}  // namespace flexkey
