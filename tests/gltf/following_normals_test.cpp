#include "flexkey/gltf/following_normals.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "gltf/clips.h"
#include "support/gltf_builder.h"

namespace flexkey::testing {
namespace {

using meshes::GltfBuilder;
using meshes::Tube;
using meshes::tube_file;

GltfFile read(const GltfBuilder& file) {
  const TemporaryFolder folder;
  return read_gltf(file.save(folder / "mesh.glb"));
}

/// Rows turned by an angle about an axis.
Positions turned(const Positions& rows, const Eigen::AngleAxisd& turn) {
  return rows * turn.toRotationMatrix().transpose();
}

TEST(FollowingNormals, AreTheFilesOwnAtRest) {
  const GltfFile file = read(tube_file());
  const FollowingNormals normals(file.file.mesh, file.source);
  EXPECT_EQ(normals.at(file.file.mesh.positions), file.source.normals);
}

TEST(FollowingNormals, TurnWithARigidMotion) {
  const GltfFile file = read(tube_file());
  const FollowingNormals normals(file.file.mesh, file.source);
  const Eigen::AngleAxisd turn(1.2, Vec3(1, 2, 3).normalized());
  const Positions found = normals.at(turned(file.file.mesh.positions, turn));
  EXPECT_LT((found - turned(file.source.normals, turn)).rowwise().norm().maxCoeff(), 1e-6);
}

TEST(FollowingNormals, AreOneAlongASeam) {
  const GltfFile file = read(tube_file());
  const FollowingNormals normals(file.file.mesh, file.source);
  Positions bent = file.file.mesh.positions;
  for (auto row : bent.rowwise()) row.x() += 0.1 * row.z() * row.z();
  const Positions found = normals.at(bent);
  for (int ring = 0; ring <= 6; ++ring) EXPECT_EQ(found.row(9 * ring), found.row(9 * ring + 8));
  EXPECT_NE(found.row(9 * 6), file.source.normals.row(9 * 6));
}

/// A ridge of two squares that meet at x = 0 with a hard edge: normals (-1, 0, 1) and (1, 0, 1), not unit
/// ones.
GltfBuilder ridge() {
  GltfBuilder file;
  const int points = file.add_points(
      {{-1, 0, -1}, {0, 0, 0}, {0, 1, 0}, {-1, 1, -1}, {0, 0, 0}, {1, 0, -1}, {1, 1, -1}, {0, 1, 0}});
  const Vec3 left = Vec3(-1, 0, 1).normalized(), right = Vec3(1, 0, 1).normalized();
  const int normals = file.add_points({left, left, left, left, right, right, right, right});
  const int corners = file.add_indices({0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7});
  file.add("meshes",
           {{"primitives",
             {{{"attributes", {{"POSITION", points}, {"NORMAL", normals}}}, {"indices", corners}}}}});
  file.add("nodes", {{"mesh", 0}});
  return file;
}

TEST(FollowingNormals, AHardEdgeStaysHard) {
  const GltfFile file = read(ridge());
  const FollowingNormals normals(file.file.mesh, file.source);
  Positions flatter = file.file.mesh.positions;
  flatter.col(2) *= 0.5;
  const Positions found = normals.at(flatter);
  const Vec3 left = Vec3(-0.5, 0, 1).normalized(), right = Vec3(0.5, 0, 1).normalized();
  for (int v = 0; v < 8; ++v)
    EXPECT_LT((found.row(v).transpose() - (v < 4 ? left : right)).norm(), 1e-6) << v;
}

TEST(FollowingNormals, AreInTheSpaceOfTheirNode) {
  GltfBuilder scaled = ridge();
  scaled.root["nodes"][0]["scale"] = {2, 1, 3};
  scaled.root["nodes"][0]["rotation"] = {0, 0.6, 0, 0.8};
  const GltfFile file = read(scaled);
  const FollowingNormals normals(file.file.mesh, file.source);
  const Eigen::Matrix3d linear = file.source.nodes[0].world.topLeftCorner<3, 3>();
  Positions local = (file.file.mesh.positions * linear.inverse().transpose());
  local.col(2) *= 0.5;
  const Positions found = normals.at(local * linear.transpose());
  EXPECT_LT((found.row(0).transpose() - Vec3(-0.5, 0, 1).normalized()).norm(), 1e-6);
  EXPECT_LT((found.row(7).transpose() - Vec3(0.5, 0, 1).normalized()).norm(), 1e-6);
}

}  // namespace
}  // namespace flexkey::testing
