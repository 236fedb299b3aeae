#include "flexkey/deform/weights.h"

#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "support/meshes.h"

namespace flexkey {
namespace {

Eigen::MatrixXd dense(const Cells& cells) {
  Eigen::MatrixXd W = Eigen::MatrixXd::Zero(cells.count(), cells.count());
  for (int i = 0; i < cells.count(); ++i) {
    for (const auto [j, weight] : cells.of(i)) W(i, j) += weight;
  }
  return W;
}

Eigen::MatrixXd dense_weights(const Mesh& mesh, Weights weights) {
  return dense(build_cells(mesh, weights));
}

/// The same mesh with every face begun at its next corner.
Mesh faces_begun_later(const Mesh& mesh) {
  Mesh result;
  result.positions = mesh.positions;
  for (int f = 0; f < mesh.face_count(); ++f) {
    std::vector<int> face(mesh.face(f).begin(), mesh.face(f).end());
    std::rotate(face.begin(), face.begin() + 1, face.end());
    result.add_face(face);
  }
  return result;
}

Mesh polygon(int n) {
  std::vector<Vec3> points;
  std::vector<int> face;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * k / n;
    points.emplace_back(std::cos(angle), 1.5 * std::sin(angle), 0.2 * std::cos(2 * angle));
    face.push_back(k);
  }
  return meshes::make_mesh(points, {face});
}

TEST(Weights, CotangentsOfATriangleOppositeToItsEdges) {
  const Mesh triangle = meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, std::sqrt(3.0), 0}}, {{0, 1, 2}});
  const Eigen::MatrixXd W = dense_weights(triangle, Weights::cotangent);  // angles 90, 60, 30 degrees
  EXPECT_NEAR(W(1, 2), 0, 1e-15);
  EXPECT_NEAR(W(2, 0), 0.5 / std::tan(std::numbers::pi / 3), 1e-15);
  EXPECT_NEAR(W(0, 1), 0.5 / std::tan(std::numbers::pi / 6), 1e-15);
}

TEST(Weights, AnInnerEdgeSumsBothItsTriangles) {
  const Mesh two =
      meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {0.5, 2, 0}, {0.5, -1, 0}}, {{0, 1, 2}, {1, 0, 3}});
  EXPECT_NEAR(dense_weights(two, Weights::cotangent)(0, 1), 0.5 * (15.0 / 8 + 3.0 / 4), 1e-14);
}

TEST(Weights, AreSymmetricWithNeighboursIncreasing) {
  const Cells cells = build_cells(meshes::bumpy(meshes::bar(3, 2, 2), 0.1), Weights::clamped);
  EXPECT_EQ(dense(cells), dense(cells).transpose());
  for (int i = 0; i < cells.count(); ++i) {
    for (std::size_t k = 1; k < cells.of(i).size(); ++k) {
      EXPECT_LT(cells.of(i)[k - 1].neighbour, cells.of(i)[k].neighbour);
    }
  }
}

TEST(Weights, OfAQuadAreTheMeanOverItsDiagonals) {
  const std::vector<Vec3> points{{0, 0, 0}, {2, 0.1, 0}, {2.5, 1.4, 0.3}, {0.2, 1, -0.2}};
  const Eigen::MatrixXd quad = dense_weights(meshes::make_mesh(points, {{0, 1, 2, 3}}), Weights::cotangent);
  const Eigen::MatrixXd one =
      dense_weights(meshes::make_mesh(points, {{0, 1, 2}, {0, 2, 3}}), Weights::cotangent);
  const Eigen::MatrixXd other =
      dense_weights(meshes::make_mesh(points, {{0, 1, 3}, {1, 2, 3}}), Weights::cotangent);
  EXPECT_LT((quad - 0.5 * (one + other)).norm(), 1e-14);
}

TEST(Weights, OfAPolygonAreTheMeanOverItsFans) {
  const Mesh pentagon = polygon(5);
  Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(5, 5);
  for (int a = 0; a < 5; ++a) {
    Mesh fan;
    fan.positions = pentagon.positions;
    for (int k = 1; k < 4; ++k) fan.add_face(std::array{a, (a + k) % 5, (a + k + 1) % 5});
    mean += dense_weights(fan, Weights::cotangent) / 5;
  }
  EXPECT_LT((dense_weights(pentagon, Weights::cotangent) - mean).norm(), 1e-14);
}

TEST(Weights, DoNotDependOnWhereAFaceBegins) {
  for (const Mesh& mesh : {meshes::bumpy(meshes::bar(3, 2, 2), 0.2), polygon(7), polygon(150)}) {
    for (const Weights weights : {Weights::clamped, Weights::cotangent, Weights::uniform}) {
      const Eigen::MatrixXd W = dense_weights(mesh, weights);
      EXPECT_LT((dense_weights(faces_begun_later(mesh), weights) - W).norm(), 1e-13 * W.norm());
    }
  }
}

TEST(Weights, ClampedHoldsEachSumAtAMillionthOfTheMean) {
  const Mesh mesh = meshes::bumpy(meshes::bar(4, 2, 2), 0.3);
  const Eigen::MatrixXd raw = dense_weights(mesh, Weights::cotangent);
  const Eigen::MatrixXd edges =
      dense_weights(mesh, Weights::uniform).unaryExpr([](double w) { return w > 0 ? 1.0 : 0.0; });
  const double floor = 1e-6 * raw.sum() / edges.sum();
  ASSERT_LT(raw.minCoeff(), -floor);
  const Eigen::MatrixXd expected = raw.cwiseMax(floor).cwiseProduct(edges);
  EXPECT_LT((dense_weights(mesh, Weights::clamped) - expected).norm(), 1e-12);
}

TEST(Weights, UniformIsOneForASideAndHalfForAQuadsDiagonal) {
  const Eigen::MatrixXd W = dense_weights(meshes::grid(2, 1), Weights::uniform);
  EXPECT_EQ(W(0, 1), 1);
  EXPECT_EQ(W(1, 4), 1);  // between two quads
  EXPECT_EQ(W(0, 4), 0.5);
  EXPECT_EQ(W(1, 3), 0.5);
  EXPECT_EQ(W(0, 2), 0);
}

TEST(Weights, StayFiniteOnTrianglesWithoutArea) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}};
  const Mesh mesh =
      meshes::make_mesh(points, {{0, 1, 2}, {0, 2, 3}, {3, 4, 5}, {2, 4, 3}, {2, 2, 4}, {5, 5, 5}});
  for (const Weights weights : {Weights::clamped, Weights::cotangent, Weights::uniform}) {
    EXPECT_TRUE(dense_weights(mesh, weights).allFinite());
  }
  EXPECT_GT(dense_weights(mesh, Weights::clamped)(0, 2), 0);
}

TEST(Weights, ASliverCountsAsAThicknessOfOneInTwoHundred) {
  const auto apex_at = [](double height) {
    return meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, height, 0}}, {{0, 1, 2}});
  };
  EXPECT_NEAR(dense_weights(apex_at(0.01), Weights::clamped)(0, 2), 0.5 * 100, 1e-10);
  EXPECT_NEAR(dense_weights(apex_at(0), Weights::clamped)(0, 2), 0.5 * 200, 1e-10);
  EXPECT_NEAR(dense_weights(apex_at(1e-3), Weights::cotangent)(0, 2), 0.5 * 1000, 1e-9);
}

/// The least eigenvalue of L over its largest; 0 where L is positive semidefinite.
double least_eigenvalue(const Mesh& mesh) {
  const Eigen::MatrixXd W = dense_weights(mesh, Weights::cotangent);
  const Eigen::MatrixXd L = Eigen::MatrixXd(W.rowwise().sum().asDiagonal()) - W;
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(L).eigenvalues();
  return values.minCoeff() / values.maxCoeff();
}

TEST(Weights, CotangentsKeepTheLaplacianPositiveOnSliversToo) {
  Mesh mesh = meshes::bumpy(meshes::bar(3, 2, 2), 0.3);
  EXPECT_GT(least_eigenvalue(mesh), -1e-14);
  mesh.positions.row(5) = mesh.positions.row(6);
  mesh.positions.row(9) = (mesh.positions.row(10) + mesh.positions.row(11)) / 2;
  EXPECT_GT(least_eigenvalue(mesh), -1e-14);
}

TEST(Weights, ATriangleWrittenAsAQuadIsATriangle) {
  const std::vector<Vec3> points{{0, 0, 0}, {2, 0.1, 0}, {1, 1.4, 0.3}};
  for (const Weights weights : {Weights::cotangent, Weights::uniform}) {
    const Eigen::MatrixXd written = dense_weights(meshes::make_mesh(points, {{0, 1, 2, 2}}), weights);
    const Eigen::MatrixXd plain = dense_weights(meshes::make_mesh(points, {{0, 1, 2}}), weights);
    EXPECT_LT((written - plain).norm(), 1e-14);
  }
}

TEST(Weights, DuplicateFacesOnlyAddUp) {
  Mesh mesh = meshes::tetrahedron();
  const Eigen::MatrixXd once = dense_weights(mesh, Weights::cotangent);
  mesh.add_face(std::array{0, 2, 1});
  const Eigen::MatrixXd more = dense_weights(mesh, Weights::cotangent) - once;
  EXPECT_NEAR(more(1, 2), 0, 1e-15);  // opposite to the right angle at vertex 0
  EXPECT_NEAR(more(0, 1), 0.5, 1e-15);
  EXPECT_EQ(dense_weights(mesh, Weights::uniform)(0, 1), 1);
}

TEST(Weights, AHugePolygonCostsAboutAsMuchAsItsCorners) {
  const int n = 2000;
  EXPECT_LT(build_cells(polygon(n), Weights::clamped).edges.size(), 150u * n);
}

TEST(Weights, AVertexOfNoTriangleHasAnEmptyCell) {
  const Mesh mesh =
      meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}, {6, 5, 5}}, {{0, 1, 2}, {3, 4}});
  const Cells cells = build_cells(mesh, Weights::clamped);
  EXPECT_EQ(cells.count(), 5);
  EXPECT_TRUE(cells.of(3).empty());
}

}  // namespace
}  // namespace flexkey
