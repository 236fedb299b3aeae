#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "flexkey/gltf/primitives.h"
#include "flexkey/gltf/write_glb.h"
#include "gltf/clips.h"
#include "gltf/glb_file.h"

namespace flexkey::testing {
namespace {

std::vector<float> only(std::size_t target, std::size_t targets) {
  std::vector<float> weights(targets, 0.0F);
  weights[target] = 1;
  return weights;
}

double degrees_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

TEST(Normals, FollowTheSurfaceInEveryFrame) {
  const Clip clip = clip_of(sheet(12), 8, [](const Vec3& p, int k) {
    return Vec3(p.x(), p.y(), 0.05 * k * std::sin(5 * p.x()) * std::cos(4 * p.y()));
  });
  const TemporaryFolder folder;
  const GltfReport report = write_glb(clip, exact(), folder / "shot.glb");
  const tinygltf::Model model = load_glb(folder / "shot.glb");
  const std::vector<int> vertices = split_primitives(clip.mesh)[0].vertices;
  double sum = 0;
  for (std::size_t k = 0; k < 8; ++k) {
    const Positions right = vertex_normals(clip.mesh, clip.frames[k]);
    const Eigen::MatrixXf normals = morphed(model, 0, "NORMAL", only(k, 8));
    for (Eigen::Index row = 0; row < normals.rows(); ++row) {
      EXPECT_NEAR(normals.row(row).norm(), 1, 1e-6);
      sum += degrees_between(normals.row(row).cast<double>(),
                             right.row(vertices[static_cast<std::size_t>(row)]));
    }
  }
  EXPECT_LT(sum / static_cast<double>(8 * vertices.size()), 1e-4);
  EXPECT_LT(report.normal_error_mean, 1e-4);
  EXPECT_GE(report.normal_error_largest, report.normal_error_mean);
}

/// The sheet cut in two along x = 0.5: the seam's vertices are there twice, at the same places.
Mesh cut_sheet() {
  Mesh whole = sheet(4);
  Mesh mesh;
  mesh.positions.resize(30, 3);
  mesh.positions.topRows(25) = whole.positions;
  for (int row = 0; row < 5; ++row) mesh.positions.row(25 + row) = whole.positions.row(5 * row + 2);
  for (int f = 0; f < whole.face_count(); ++f) {
    std::vector<int> face(whole.face(f).begin(), whole.face(f).end());
    for (int& v : face) {
      if (f % 4 >= 2 && v % 5 == 2) v = 25 + v / 5;
    }
    mesh.add_face(face);
  }
  return mesh;
}

Vec3 fold(const Vec3& p, int frame) {
  return {p.x(), p.y(), 0.2 * frame * std::abs(p.x() - 0.5) + 0.1 * frame * p.x()};
}

/// The normals in a frame of all vertices at this place.
std::vector<Vec3> normals_at(const tinygltf::Model& model, const Vec3& place, std::size_t frame) {
  std::vector<Vec3> found;
  const std::size_t targets = model.meshes[0].weights.size();
  for (std::size_t i = 0; i < model.meshes[0].primitives.size(); ++i) {
    const Eigen::MatrixXf base = morphed(model, i, "POSITION", std::vector<float>(targets, 0.0F));
    const Eigen::MatrixXf normals = morphed(model, i, "NORMAL", only(frame, targets));
    for (Eigen::Index row = 0; row < base.rows(); ++row) {
      const Vec3 there = base.row(row).cast<double>();
      if ((there - place).norm() < 1e-6) found.push_back(normals.row(row).cast<double>());
    }
  }
  return found;
}

void expect_one_normal(const Clip& clip) {
  const TemporaryFolder folder;
  write_glb(clip, exact(), folder / "shot.glb");
  const tinygltf::Model model = load_glb(folder / "shot.glb");
  for (std::size_t frame = 0; frame < clip.frames.size(); ++frame) {
    const std::vector<Vec3> normals = normals_at(model, {0.5, 0.5, 0}, frame);
    ASSERT_EQ(normals.size(), 2u);
    EXPECT_EQ(normals[0], normals[1]);
  }
}

TEST(Normals, AreOneAcrossVerticesThatTheFileSplit) {
  expect_one_normal(clip_of(cut_sheet(), 3, fold));
}

TEST(Normals, AreOneAcrossUvSeams) {
  Mesh mesh = sheet(4);
  unwrap_flat(mesh);
  const auto texcoords = mesh.texcoords.rows();
  mesh.texcoords.conservativeResize(2 * texcoords, 2);
  mesh.texcoords.bottomRows(texcoords) = mesh.texcoords.topRows(texcoords).array() + 2;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (f % 4 < 2) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      mesh.corner_texcoord[static_cast<std::size_t>(4 * f) + i] += static_cast<int>(texcoords);
    }
  }
  expect_one_normal(clip_of(mesh, 3, fold));
}

TEST(Normals, AreOneAcrossMaterials) {
  Mesh mesh = sheet(4);
  mesh.materials = {material("left"), material("right")};
  for (int f = 0; f < mesh.face_count(); ++f) mesh.face_material.push_back(f % 4 < 2 ? 0 : 1);
  expect_one_normal(clip_of(mesh, 3, fold));
}

TEST(Normals, AreInEveryTargetOrNowhere) {
  const Clip clip = clip_of(cube(), 4, [](const Vec3& p, int k) { return k == 1 ? p : twist(p, k); });
  const TemporaryFolder folder;
  for (const bool normals : {true, false}) {
    GltfOptions options = exact();
    options.normals = normals;
    write_glb(clip, options, folder / "shot.glb");
    const tinygltf::Model model = load_glb(folder / "shot.glb");
    const tinygltf::Primitive& primitive = model.meshes[0].primitives[0];
    EXPECT_EQ(primitive.attributes.contains("NORMAL"), normals);
    for (const auto& target : primitive.targets) {
      EXPECT_TRUE(target.contains("POSITION"));
      EXPECT_EQ(target.contains("NORMAL"), normals);
      EXPECT_FALSE(target.contains("TANGENT"));
    }
  }
}

}  // namespace
}  // namespace flexkey::testing
