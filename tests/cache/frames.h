#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "flexkey/cache/frame_sink.h"
#include "flexkey/mesh/read_file.h"
#include "support/meshes.h"

namespace flexkey::test {

/// A cube and a triangle in its air, none of their coordinates a float: quads and a triangle, a vertex (8)
/// that no face names, texture coordinates that one face lacks, groups that overlap, a material that one face
/// lacks.
inline Mesh mixed_mesh() {
  Mesh mesh = meshes::cube();
  mesh.positions.conservativeResize(12, 3);
  mesh.positions.bottomRows(4) << 5, 5, 5, 0, 0, 3, 1, 0, 3, 0, 1, 3;
  mesh.positions.array() += 0.1;
  mesh.add_face(std::vector<int>{9, 10, 11});
  mesh.texcoords.resize(4, 2);
  mesh.texcoords << 0, 0, 1.0 / 3, 0, 1, 1, 0, 1;
  for (int f = 0; f < 6; ++f) mesh.corner_texcoord.insert(mesh.corner_texcoord.end(), {0, 1, 2, 3});
  mesh.corner_texcoord.insert(mesh.corner_texcoord.end(), {-1, -1, -1});
  Material red, blue;
  red.name = "shiny red";
  blue.name = "blue";
  mesh.materials = {red, blue};
  mesh.face_material = {-1, 0, 0, 1, 0, 0, 1};
  mesh.groups = {{"left", {1, 2}}, {"top", {2, 3, 6}}};
  return mesh;
}

/// Where the vertices are on frame k: never the same twice.
inline Positions posed(const Mesh& mesh, int k) {
  Positions positions = mesh.positions;
  for (Eigen::Index v = 0; v < positions.rows(); ++v)
    positions(v, 1) += std::sin(0.7 * k + positions(v, 0)) / 3;
  return positions;
}

inline double lambda_of(int k) {
  return 0.01 * k;
}

/// The matrix of handle h on frame k: no two of its numbers are the same.
inline Eigen::Matrix4d matrix_of(int h, int k) {
  Eigen::Matrix4d matrix;
  for (Eigen::Index n = 0; n < 16; ++n) matrix(n / 4, n % 4) = static_cast<double>(n) + 100 * h + k / 3.0;
  return matrix;
}

inline void add_frame(const FrameSink& sink, const CacheShape& shape, int k) {
  const FrameReport report{.frame = k, .lambda = lambda_of(k), .converged = true};
  std::vector<Eigen::Matrix4d> handles;
  for (std::size_t h = 0; h < shape.handles.size(); ++h) handles.push_back(matrix_of(static_cast<int>(h), k));
  sink.add({report, posed(shape.mesh, k), handles});
}

/// All frames of the shape; the bytes that the sink says it wrote.
inline std::uintmax_t write_all(const FrameSink& sink, const CacheShape& shape) {
  for (const int k : shape.frames) add_frame(sink, shape, k);
  return sink.finish();
}

/// A test with an empty folder of its own.
class Folder : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  void TearDown() override { std::filesystem::remove_all(path_); }

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  bool is_empty() const { return std::filesystem::is_empty(path_); }

 private:
  const testing::TestInfo* info_ = testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path path_ =
      std::filesystem::path(testing::TempDir()) /
      (std::string("flexkey_cache_") + info_->test_suite_name() + "_" + info_->name());
};

}  // namespace flexkey::test
