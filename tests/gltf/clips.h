#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <system_error>

#include <unistd.h>

#include "flexkey/animate/clip.h"
#include "flexkey/gltf/write_glb.h"

namespace flexkey::testing {

/// A folder that is there as long as the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "flexkey-gltf-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::system_error(errno, std::generic_category(), name);
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The cube from 0.1 to 1.1 in six quads, so that no coordinate is a float.
inline Mesh cube() {
  Mesh mesh;
  mesh.positions.resize(8, 3);
  for (int v = 0; v < 8; ++v) mesh.positions.row(v) << 0.1 + (v & 1), 0.1 + (v >> 1 & 1), 0.1 + (v >> 2 & 1);
  const std::array<std::array<int, 4>, 6> faces = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& face : faces) mesh.add_face(face);
  return mesh;
}

/// A sheet of cells x cells quads in the plane z = 0 over the unit square, row after row of vertices.
inline Mesh sheet(int cells) {
  Mesh mesh;
  const int side = cells + 1;
  mesh.positions.resize(side * side, 3);
  for (int v = 0; v < side * side; ++v) {
    mesh.positions.row(v) << static_cast<double>(v % side) / cells, static_cast<double>(v / side) / cells, 0;
  }
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const int v = row * side + column;
      mesh.add_face(std::array{v, v + 1, v + side + 1, v + side});
    }
  }
  return mesh;
}

inline Material material(const std::string& name) {
  Material result;
  result.name = name;
  return result;
}

/// Texture coordinates of the sheet's own vertices: x, y of the rest position.
inline void unwrap_flat(Mesh& mesh) {
  mesh.texcoords = mesh.positions.leftCols(2);
  mesh.corner_texcoord = mesh.corners;
}

/// One target a frame, as it is.
inline GltfOptions exact() {
  GltfOptions options;
  options.basis = BasisKind::frames;
  return options;
}

using Motion = std::function<Vec3(const Vec3& rest, int frame)>;

inline Clip clip_of(Mesh mesh, int frames, const Motion& motion) {
  Clip clip;
  clip.name = "test shot";
  clip.fps = 24;
  clip.mesh = std::move(mesh);
  for (int k = 0; k < frames; ++k) {
    Positions frame = clip.mesh.positions;
    for (Eigen::Index v = 0; v < frame.rows(); ++v)
      frame.row(v) = motion(frame.row(v).transpose(), k).transpose();
    clip.frames.push_back(std::move(frame));
    clip.reports.push_back(
        {.frame = k, .lambda = 0.5 + 0.01 * k, .solves = 1, .estimate = 0, .converged = true});
  }
  return clip;
}

/// Turns about z by 0.1 a unit of height and frame, and leans over: every vertex off the axis moves.
inline Vec3 twist(const Vec3& p, int frame) {
  const double angle = 0.1 * frame * (p.z() + 0.3);
  return {p.x() * std::cos(angle) - p.y() * std::sin(angle),
          p.x() * std::sin(angle) + p.y() * std::cos(angle), p.z() + 0.01 * frame * p.x()};
}

/// A bump in the corner x, y < 0.3 of the sheet; the rest stays where it is.
inline Vec3 bump(const Vec3& p, int frame) {
  const double x = std::max(0.0, 0.3 - p.x()), y = std::max(0.0, 0.3 - p.y());
  return p + Vec3(0, 0, 3.0 * frame * x * y);
}

inline Vec3 stay(const Vec3& p, int) {
  return p;
}

}  // namespace flexkey::testing
