#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numeric>
#include <vector>

#include "deform/dense_paper.h"
#include "flexkey/deform/deformer.h"
#include "flexkey/deform/vertex_areas.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

TEST(VertexAreas, AreAThirdOfTheTriangles) {
  const Mesh two =
      meshes::make_mesh({{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {0, 0, 2}, {9, 9, 9}}, {{0, 1, 2}, {1, 0, 3}});
  const Eigen::VectorXd areas = vertex_areas(two);  // of triangles of 6 and 3
  EXPECT_NEAR(areas(0), 3, 1e-14);
  EXPECT_NEAR(areas(1), 3, 1e-14);
  EXPECT_NEAR(areas(2), 2, 1e-14);
  EXPECT_NEAR(areas(3), 1, 1e-14);
  EXPECT_EQ(areas(4), 0);
}

TEST(VertexAreas, OfAQuadAreTheMeanOverItsDiagonals) {
  const std::vector<Vec3> points{{0, 0, 0}, {2, 0.1, 0}, {2.5, 1.4, 0.3}, {0.2, 1, -0.2}};
  const auto areas = [&](const std::vector<std::vector<int>>& faces) {
    return vertex_areas(meshes::make_mesh(points, faces));
  };
  const Eigen::VectorXd mean = (areas({{0, 1, 2}, {0, 2, 3}}) + areas({{0, 1, 3}, {1, 2, 3}})) / 2;
  EXPECT_LT((areas({{0, 1, 2, 3}}) - mean).norm(), 1e-15);
  EXPECT_LT((areas({{2, 3, 0, 1}}) - mean).norm(), 1e-15);
}

TEST(VertexAreas, RowWeightsAreOneOverTheAreaAndBounded) {
  const Mesh mesh =
      meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {9, 9, 9}}, {{0, 1, 2, 3}});
  const Eigen::VectorXd weights = row_weights(mesh);  // the mean area is 0.2, the corners' a quarter
  EXPECT_LT((weights.head(4).array() - 0.8).abs().maxCoeff(), 1e-14);
  EXPECT_NEAR(weights(4), 1e6, 1e-6);
  EXPECT_EQ(row_weights(meshes::make_mesh({{0, 0, 0}, {1, 0, 0}}, {})), Eigen::VectorXd::Ones(2));
}

/// A strip 8 long and 2 wide with a column of quads between each two of `lines`, which run from 0 to 8.
Mesh strip(const std::vector<double>& lines) {
  Mesh mesh = meshes::triangulated(meshes::grid(static_cast<int>(lines.size()) - 1, 4));
  for (Eigen::Index v = 0; v < mesh.positions.rows(); ++v) {
    mesh.positions(v, 0) = lines[static_cast<std::size_t>(mesh.positions(v, 0))];
    mesh.positions(v, 1) /= 2;
  }
  return mesh;
}

/// Lines `far` apart on the low half and `near` on the high half.
std::vector<double> lines(double far, double near) {
  std::vector<double> at{0};
  while (at.back() < 8 - 1e-9) at.push_back(at.back() + (at.back() < 4 - 1e-9 ? far : near));
  return at;
}

/// The strip held at its low end and bent by its high end, at the vertices whose x is a multiple of a half.
Positions bent(const Mesh& mesh, const DeformOptions& options) {
  Constraints held{meshes::between(mesh, 0, -1, 0.6), {}};
  for (const int v : meshes::between(mesh, 0, 7.4, 9)) held.handles.push_back(v);
  Positions targets = mesh.positions(held.handles, Eigen::all);
  for (Eigen::Index k = 0; k < targets.rows(); ++k) {
    if (targets(k, 0) < 4) continue;
    const Vec3 from_end = targets.row(k).transpose() - Vec3(8, 1, 0);
    targets.row(k) = (meshes::turn(-60, {0, 1, 0}) * from_end + Vec3(6, 1, 3)).transpose();
  }
  const Deformer deformer(mesh, held, options);
  Pose pose = deformer.rest_pose();
  EXPECT_TRUE(deformer.solve(targets, 0, pose).converged);
  std::vector<int> shared;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const double twice = 2 * mesh.positions(v, 0);
    if (std::abs(twice - std::round(twice)) < 1e-6) shared.push_back(v);
  }
  return pose.positions(shared, Eigen::all);
}

TEST(AreaWeighting, MakesADenseHalfCountNoLessThanACoarseOne) {
  DeformOptions by_area{.iterations = 1000, .tolerance = 1e-7};
  DeformOptions plain = by_area;
  by_area.area_weighting = true;
  const Mesh even = strip(lines(0.5, 0.5)), uneven = strip(lines(0.5, 0.0625));
  const auto away = [&](const DeformOptions& options) {
    return (bent(uneven, options) - bent(even, options)).rowwise().norm().maxCoeff();
  };
  EXPECT_LT(away(by_area), 0.4 * away(plain));
}

TEST(AreaWeighting, OfAnEvenClosedSurfaceChangesNothing) {
  const Mesh tetrahedron = meshes::make_mesh({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                                             {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
  const auto answer = [&](bool by_area) {
    const Deformer deformer(tetrahedron, {{0, 1}, {}}, {.area_weighting = by_area});
    Pose pose = deformer.rest_pose();
    deformer.solve(Positions{{1, 1, 2}, {1, -2, -1}}, 0.5, pose);
    return pose.positions;
  };
  EXPECT_LT((answer(true) - answer(false)).norm(), 1e-13);
}

TEST(AreaWeighting, IsEquation7WithItsRowsOverTheRootOfTheirArea) {
  Mesh mesh = meshes::bumpy(meshes::bar(5, 2, 1), 0.2);
  std::vector<int> held = meshes::between(mesh, 0, -1, 0.5);
  for (const int v : meshes::between(mesh, 0, 4.5, 9)) held.push_back(v);
  std::vector<int> free;
  for (const int v : meshes::between(mesh, 0, 0.5, 4.5)) free.push_back(v);
  Positions targets = mesh.positions(held, Eigen::all);
  targets.bottomRows(6).col(1).array() += 2;

  // From rest the first solve has R = S = 1: r = L p. The ends reach into no row that is not a neighbour's.
  const Eigen::MatrixXd L = dense::laplacian(dense::weights(mesh, Weights::clamped));
  const Eigen::VectorXd root = vertex_areas(mesh).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd DL = root.asDiagonal() * L;
  const Eigen::MatrixXd b = DL * mesh.positions - DL(Eigen::all, held) * targets;
  std::vector<int> rows;
  for (int i = 0; i < L.rows(); ++i) {
    if ((L(i, free).array() != 0).any()) rows.push_back(i);
  }
  const Eigen::MatrixXd expected =
      Eigen::MatrixXd(DL(rows, free)).colPivHouseholderQr().solve(b(rows, Eigen::all));

  const Deformer deformer(mesh, {held, {}}, {.area_weighting = true, .iterations = 1});
  Pose pose = deformer.rest_pose();
  deformer.solve(targets, 0.5, pose);
  EXPECT_LT((pose.positions(free, Eigen::all) - expected).norm(), 1e-10);
}

}  // namespace
}  // namespace flexkey
