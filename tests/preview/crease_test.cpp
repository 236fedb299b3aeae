// Creases: edges that subdivision leaves sharp.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "flexkey/mesh/connectivity.h"
#include "flexkey/preview/control_mesh.h"
#include "flexkey/preview/subdivision.h"
#include "preview/surfaces.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

using Eigen::RowVector3f;

constexpr float kClose = 1e-6f;

int vertex_at(const Mesh& mesh, const Vec3& place) {
  Eigen::Index v = 0;
  EXPECT_EQ((mesh.positions.rowwise() - place.transpose()).rowwise().norm().minCoeff(&v), 0);
  return static_cast<int>(v);
}

/// A cube whose top, at z = 1, has creases around it.
Mesh creased_cube(double sharpness) {
  Mesh cube = meshes::cube();
  const std::array<Vec3, 4> loop{Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(0, 1, 1)};
  for (std::size_t k = 0; k < 4; ++k)
    cube.creases.push_back({vertex_at(cube, loop[k]), vertex_at(cube, loop[(k + 1) % 4]), sharpness});
  return cube;
}

Points refined(const Mesh& mesh, int level) {
  return refined_points(Subdivision(mesh, level), mesh.positions);
}

RowVector3f corner_at(const Mesh& mesh, int level, const Vec3& place) {
  const Subdivision subdivision(mesh, level);
  const auto vertex = static_cast<std::size_t>(vertex_at(mesh, place));
  return refined_points(subdivision, mesh.positions).row(subdivision.surface().of_vertex[vertex]);
}

// DeRose, Kass and Truong 1998: an infinitely sharp crease is the uniform cubic B-spline of its vertices. A
// vertex goes to (a + 6 v + b) / 8 and is at (a + 4 v + b) / 6 in the limit; its second difference, of which
// it is off by a sixth, is divided by four at each level.
TEST(Crease, AnInfinitelySharpLoopOfACubeIsTheSplineOfItsVertices) {
  const Mesh cube = creased_cube(infinitely_sharp);
  const RowVector3f v(1, 1, 1), difference(-1, -1, 0);  // of its neighbours (0, 1, 1) and (1, 0, 1)
  for (int level = 1; level <= 4; ++level) {
    const RowVector3f expected = v + difference / 6 - difference / 6 * std::pow(0.25f, level);
    EXPECT_LT((corner_at(cube, level, {1, 1, 1}) - expected).norm(), kClose) << level;
    // Nothing below draws the loop out of its plane: 4 edges make 2^level points each.
    const Points points = refined(cube, level);
    const auto on_top = (points.col(2).array() > 1 - kClose).count();
    const Eigen::Index side = Eigen::Index{1} << level;
    EXPECT_EQ(on_top, (side + 1) * (side + 1)) << "the whole top lies in the plane of its border";
  }
  EXPECT_LT(refined(meshes::cube(), 1).col(2).maxCoeff(), 1 + kClose);
  EXPECT_LT(corner_at(meshes::cube(), 1, {1, 1, 1}).z(), 0.9f) << "without creases it is rounded off";
}

TEST(Crease, SharpnessLastsForAsManyLevels) {
  const Mesh once = creased_cube(1), always = creased_cube(infinitely_sharp);
  EXPECT_EQ(refined(once, 1), refined(always, 1));
  EXPECT_LT(corner_at(once, 2, {1, 1, 1}).z(), 1 - 0.01f);
}

TEST(Crease, ASharpVertexStaysWhereItIs) {
  Mesh cube = meshes::cube();
  cube.sharp_vertices.push_back({vertex_at(cube, {1, 1, 1}), infinitely_sharp});
  EXPECT_EQ(corner_at(cube, 3, {1, 1, 1}), RowVector3f(1, 1, 1));
}

TEST(Crease, LoopSubdivisionHasThemToo) {
  Mesh grid = meshes::triangulated(meshes::grid(4, 4));
  for (int y = 0; y < 4; ++y) grid.creases.push_back({2 + 5 * y, 2 + 5 * (y + 1), infinitely_sharp});
  grid.positions(12, 2) = 8;  // the middle of the crease, (2, 2)
  const Points points = refined(grid, 1);
  const auto has = [&](const RowVector3f& p) {
    return (points.rowwise() - p).rowwise().norm().minCoeff() < kClose;
  };
  EXPECT_TRUE(has({2, 2, 6})) << "6/8 of the vertex";
  EXPECT_TRUE(has({2, 1, 1})) << "1/8 of it";
  EXPECT_TRUE(has({2, 1.5f, 4}));
}

/// The mesh with its vertices in another order, a vertex that no face uses before them, and those of the
/// top's faces apart from the others, as a seam has them.
Mesh cut_and_shuffled(const Mesh& mesh) {
  std::vector<Vec3> points{{7, 7, 7}};
  std::map<std::pair<int, bool>, int> number;
  std::vector<std::vector<int>> faces;
  for (int f = mesh.face_count() - 1; f >= 0; --f) {
    bool is_top = true;
    for (const int v : mesh.face(f)) is_top = is_top && mesh.positions(v, 2) == 1;
    faces.emplace_back();
    for (const int v : mesh.face(f)) {
      const auto [found, is_new] = number.insert({{v, is_top}, static_cast<int>(points.size())});
      if (is_new) points.emplace_back(mesh.positions.row(v).transpose());
      faces.back().push_back(found->second);
    }
  }
  Mesh cut = meshes::make_mesh(points, faces);
  for (const Crease& crease : mesh.creases)
    cut.creases.push_back({number.at({crease.to, false}), number.at({crease.from, false}), crease.sharpness});
  return cut;
}

TEST(Crease, SurvivesAnotherOrderAndASeam) {
  const Mesh cube = creased_cube(infinitely_sharp), cut = cut_and_shuffled(cube);
  EXPECT_EQ(control_mesh(cut, 0).mesh.creases.size(), 4u);
  for (const Vec3& corner : {Vec3(1, 1, 1), Vec3(0, 1, 1), Vec3(1, 0, 0)})
    EXPECT_LT((corner_at(cut, 3, corner) - corner_at(cube, 3, corner)).norm(), kClose);
}

TEST(Crease, OneThatWeldingCollapsesIsGone) {
  Mesh mesh =
      meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1e-4}}, {{0, 1, 2, 4, 3}});
  mesh.creases = {{3, 4, 2}, {0, 1, 2}};
  const ControlMesh control = control_mesh(mesh, 1e-3);
  ASSERT_EQ(control.mesh.creases.size(), 1u);
  EXPECT_EQ(control.mesh.creases[0].sharpness, 2);
}

TEST(Crease, LeavesTextureCoordinatesAsTheyAre) {
  Mesh grid = meshes::grid(4, 2);  // its left and right half in two places of the texture
  grid.texcoords.resize(2 * grid.vertex_count(), 2);
  grid.texcoords.topRows(grid.vertex_count()) = grid.positions.leftCols(2) / 8;
  grid.texcoords.bottomRows(grid.vertex_count()) =
      (grid.positions.leftCols(2) / 8).rowwise() + Eigen::RowVector2d(0.5, 0.5);
  for (int f = 0; f < grid.face_count(); ++f)
    for (const int v : grid.face(f)) grid.corner_texcoord.push_back(f % 4 < 2 ? v : v + grid.vertex_count());
  Mesh creased = grid;
  for (const MeshEdge& edge : mesh_edges(grid)) creased.creases.push_back({edge.low, edge.high, 3});
  const auto plain = Subdivision(grid, 2).surface().texcoords;
  const auto sharp = Subdivision(creased, 2).surface().texcoords;
  ASSERT_EQ(sharp.size(), plain.size());
  for (std::size_t t = 0; t < sharp.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_LT((sharp[t][k] - plain[t][k]).norm(), kClose);
}

}  // namespace
}  // namespace flexkey
