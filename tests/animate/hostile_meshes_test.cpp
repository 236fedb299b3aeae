// The promise of SECURITY.md for meshes: whatever is wrong with one, it solves to a finite, sensible answer,
// or the message names what is wrong and where.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "animate/shots.h"
#include "flexkey/animate/animate.h"
#include "flexkey/mesh/defects.h"
#include "flexkey/mesh/weld.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

using meshes::bar;
using meshes::bumpy;
using meshes::grid;
using meshes::joined;
using meshes::make_mesh;
using meshes::tetrahedron;
using meshes::triangulated;

/// A mesh that is held at its low end in x and pulled aside by 30 % of its diagonal at the other.
struct HostileMesh {
  std::string name;
  Mesh mesh;
  std::string defects = {};  // what `describe` must say among others; empty: nothing
  std::string refusal = {};  // what the solve must say; empty: it solves
};

Mesh with_faces(Mesh mesh, const std::vector<std::vector<int>>& faces) {
  for (const std::vector<int>& face : faces) mesh.add_face(face);
  return mesh;
}

Mesh scaled(Mesh mesh, const Vec3& factors) {
  mesh.positions = mesh.positions * factors.asDiagonal();
  return mesh;
}

Mesh shifted(Mesh mesh, const Vec3& by) {
  mesh.positions.rowwise() += by.transpose();
  return mesh;
}

/// Every other face runs the other way.
Mesh half_flipped(const Mesh& mesh) {
  Mesh result;
  result.positions = mesh.positions;
  for (int f = 0; f < mesh.face_count(); ++f) {
    std::vector<int> face(mesh.face(f).begin(), mesh.face(f).end());
    if (f % 2 == 1) std::reverse(face.begin(), face.end());
    result.add_face(face);
  }
  return result;
}

/// Three sheets along x that share their edge on the x axis.
Mesh book() {
  std::vector<Vec3> points;
  for (double x = 0; x <= 6; ++x)
    points.insert(points.end(), {{x, 0, 0}, {x, 1, 0}, {x, -0.5, 1}, {x, -0.5, -1}});
  std::vector<std::vector<int>> faces;
  for (int x = 0; x < 6; ++x)
    for (const int page : {1, 2, 3}) faces.push_back({4 * x, 4 * x + 4, 4 * x + 4 + page, 4 * x + page});
  return make_mesh(points, faces);
}

/// Two bars that share one corner alone.
Mesh bow_tie() {
  return joined(bar(3, 1, 1), shifted(bar(3, 1, 1), {3, 1, 1}));
}

Mesh moebius_strip() {
  constexpr int parts = 24;
  std::vector<Vec3> points;
  std::vector<std::vector<int>> faces;
  for (int k = 0; k < parts; ++k) {
    const double turn = 2 * std::numbers::pi * k / parts;
    for (const double side : {-0.3, 0.3}) {
      const double radius = 1 + side * std::cos(turn / 2);
      points.emplace_back(radius * std::cos(turn), radius * std::sin(turn), side * std::sin(turn / 2));
    }
    const int a = 2 * k, b = 2 * k + 1, c = (2 * k + 2) % (2 * parts), d = (2 * k + 3) % (2 * parts);
    faces.push_back(k + 1 < parts ? std::vector<int>{a, c, d, b} : std::vector<int>{a, d, c, b});
  }
  return make_mesh(points, faces);
}

/// A sheet that stands on the middle of the lying one, and shares no vertex with it.
Mesh upright(int nx, int nz) {
  Mesh mesh = grid(nx, nz);
  mesh.positions.col(2) = mesh.positions.col(1).array() - 1.5;
  mesh.positions.col(1).setConstant(1.5);
  return mesh;
}

Mesh all_on_a_line() {
  return make_mesh({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}, {{0, 1, 2}, {1, 2, 3}});
}

std::vector<HostileMesh> hostile_meshes() {
  const Mesh sheet = grid(6, 4), block = bumpy(bar(6, 2, 2), 0.1);
  return {
      {"one triangle", make_mesh({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}}, {{0, 1, 2}})},
      {"degenerate faces", with_faces(sheet, {{0, 0, 1}, {1, 1, 1}, {7, 8, 9}}),
       "3 degenerate faces (24, 25, 26)"},
      {"faces twice", joined(sheet, sheet), "24 duplicate faces (24, 25, 26, 27, 28, …)"},
      {"a non-manifold edge", book(), "6 non-manifold edges (0-4, 4-8, 8-12, 12-16, 16-20, …)"},
      {"a non-manifold vertex", bow_tie()},
      {"flipped faces", half_flipped(sheet), "flipped edges"},
      {"a surface with one side", moebius_strip(), "1 flipped edge (0-1)"},
      {"disconnected parts", joined(block, shifted(tetrahedron(), {3, 8, 0}))},
      {"vertices of no face", joined(sheet, make_mesh({{3, 9, 9}, {4, 9, 9}}, {})),
       "2 unreferenced vertices (35, 36)"},
      {"very small", scaled(block, Vec3::Constant(1e-20))},
      {"very large", scaled(block, Vec3::Constant(1e20))},
      {"far away", shifted(block, {1e7, -1e7, 1e7})},
      {"flat", sheet},
      {"flat and slanted", make_mesh({{0, 0, 0}, {1, 0, 1}, {2, 0, 2}, {0, 1, 0}, {1, 1, 1}, {2, 1, 2}},
                                     {{0, 1, 4, 3}, {1, 2, 5, 4}})},
      {"parts that touch along a face", joined(bar(3, 1, 1), shifted(bar(3, 1, 1), {0, 1, 0})),
       "duplicate faces"},
      {"a sheet through another", joined(sheet, upright(6, 4))},
      {"slivers", scaled(triangulated(sheet), {1, 1e-9, 1})},
      {"slivers the other way", scaled(triangulated(sheet), {1, 1e7, 1})},
      {"one needle", with_faces(joined(sheet, make_mesh({{0.5, -1e-9, 0}}, {})), {{1, 0, 35}})},
      {"a polygon that crosses itself",
       make_mesh({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}}, {{0, 1, 2, 3}})},
      {"all vertices on a line", all_on_a_line(), "2 degenerate faces (0, 1)",
       "the component of 4 vertices at vertex 0 has no area"},
  };
}

/// How far the far end goes, file units.
double pull_of(const Mesh& mesh) {
  return 0.3 * bounds_of(mesh.positions).diagonal();
}

Shot pulled(const Mesh& mesh) {
  Shot shot = test::shot_of(
      "mesh: m.obj\nfps: 2\nhandles:\n"
      "  low: {select: {axis: x, below: 1%}}\n"
      "  high: {select: {axis: x, above: 99%}, move: {keys: {0s: [0, 0, 0], 1s: [0, 1, 0]}}}\n");
  shot.handles[1].move.back().value *= pull_of(mesh);
  return shot;
}

/// The last frame; its handles are where they must be.
Positions solved(const Mesh& mesh) {
  const Shot shot = pulled(mesh);
  const Scene scene = bind_shot(shot, mesh);
  const Clip clip = animate(shot, mesh, scene);
  EXPECT_EQ(clip.frames.front(), mesh.positions);
  const Positions targets = sample_targets(scene, 1);
  for (std::size_t v = 0; v < scene.weld.to_surface.size(); ++v) {
    const auto& handles = scene.constraints.handles;
    const auto led = std::find(handles.begin(), handles.end(), scene.weld.to_surface[v]);
    if (led != handles.end()) {
      EXPECT_EQ(clip.frames.back().row(static_cast<Eigen::Index>(v)), targets.row(led - handles.begin()));
    }
  }
  return clip.frames.back();
}

std::string refusal_of(const Mesh& mesh) {
  try {
    solved(mesh);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(HostileMeshes, SolveToAFiniteSensibleAnswerOrAreRefusedByName) {
  for (const HostileMesh& hostile : hostile_meshes()) {
    SCOPED_TRACE(hostile.name);
    const std::string refusal = refusal_of(hostile.mesh);
    EXPECT_EQ(refusal, hostile.refusal);
    if (!refusal.empty()) continue;
    const Positions answer = solved(hostile.mesh);
    EXPECT_TRUE(answer.allFinite());
    const double farthest = (answer - hostile.mesh.positions).rowwise().norm().maxCoeff();
    EXPECT_LT(farthest, 1.5 * pull_of(hostile.mesh)) << "nothing goes much farther than what pulls it";
  }
}

TEST(HostileMeshes, HaveTheirDefectsNamedWithPlaces) {
  for (const HostileMesh& hostile : hostile_meshes()) {
    std::string lines;
    for (const std::string& line : describe(find_defects(weld(hostile.mesh).surface)))
      lines += (lines.empty() ? "" : "; ") + line;
    EXPECT_THAT(lines, testing::HasSubstr(hostile.defects)) << hostile.name;
    if (hostile.defects.empty()) {
      EXPECT_EQ(lines, "") << hostile.name;
    }
  }
}

TEST(HostileMeshes, OfAnySizeHaveTheSameAnswerToTheBit) {
  const Mesh block = bumpy(bar(6, 2, 2), 0.1);
  const Positions answer = solved(block);
  for (const int power : {-66, -20, 20, 66}) {  // 2^66 is 7e19
    const double factor = std::ldexp(1, power);
    EXPECT_EQ(solved(scaled(block, Vec3::Constant(factor))), answer * factor) << power;
  }
}

TEST(HostileMeshes, FarFromTheOriginHaveTheAnswerThatTheirRoundedVerticesAllow) {
  const Mesh block = bumpy(bar(6, 2, 2), 0.1);
  const Vec3 away(1e7, -1e7, 1e7);
  const Positions there = solved(block).rowwise() + away.transpose();
  const double rounding = 1e7 * std::numeric_limits<double>::epsilon();
  EXPECT_LT((solved(shifted(block, away)) - there).cwiseAbs().maxCoeff(), 20 * rounding);
}

}  // namespace
}  // namespace flexkey
