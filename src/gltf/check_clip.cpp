#include "flexkey/gltf/check_clip.h"

#include <fmt/format.h>

#include <algorithm>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

// Leaves room for differences of two positions within a float's 3.4e38.
constexpr double kFarthest = 1e38;

// The weights of one target a frame are a square of the frames, whose sparse indices have 32 bits.
constexpr std::size_t kMostFrames = 65'535;

void require(bool holds, const std::string& problem) {
  if (!holds) throw InputError(problem);
}

bool all_within(const std::vector<int>& indices, int first, Eigen::Index count) {
  return std::all_of(indices.begin(), indices.end(), [&](int i) { return i >= first && i < count; });
}

bool partitions(const std::vector<int>& offsets, std::size_t corners) {
  if (offsets.empty()) return corners == 0;
  return offsets.front() == 0 && std::is_sorted(offsets.begin(), offsets.end()) &&
         static_cast<std::size_t>(offsets.back()) == corners;
}

void check_mesh(const Mesh& mesh) {
  require(partitions(mesh.face_offsets, mesh.corners.size()),
          "the faces of the mesh do not match its corners");
  require(all_within(mesh.corners, 0, mesh.vertex_count()),
          "a face of the mesh names a vertex that is not there");
  for (int f = 0; f < mesh.face_count(); ++f) {
    require(mesh.face(f).size() >= 3, fmt::format("face {} of the mesh has fewer than three corners", f));
  }
  const std::vector<int>& texcoords = mesh.corner_texcoord;
  require(texcoords.empty() || texcoords.size() == mesh.corners.size(),
          "the mesh has texture coordinates for some corners only");
  require(all_within(texcoords, -1, mesh.texcoords.rows()),
          "a corner names a texture coordinate that is not there");
  require(mesh.texcoords.cast<float>().allFinite(),
          "the mesh has a texture coordinate that is not a finite number");
  const std::vector<int>& materials = mesh.face_material;
  require(materials.empty() || materials.size() == static_cast<std::size_t>(mesh.face_count()),
          "the mesh has materials for some faces only");
  require(all_within(materials, -1, static_cast<Eigen::Index>(mesh.materials.size())),
          "a face names a material that is not there");
}

void check_positions(const Positions& positions, const std::string& whose) {
  for (Eigen::Index v = 0; v < positions.rows(); ++v) {
    const bool fits = (positions.row(v).array().abs() <= kFarthest).all();
    require(fits, fmt::format("vertex {} of {} is at ({}, {}, {}), which glTF cannot hold", v, whose,
                              positions(v, 0), positions(v, 1), positions(v, 2)));
  }
}

}  // namespace

void check_clip(const Clip& clip) {
  require(!clip.frames.empty(), "the clip has no frames");
  require(clip.frames.size() <= kMostFrames,
          fmt::format("the clip has {} frames, and at most {} are written", clip.frames.size(), kMostFrames));
  require(
      clip.reports.size() == clip.frames.size(),
      fmt::format("the clip has {} frames and {} reports of them", clip.frames.size(), clip.reports.size()));
  for (std::size_t k = 1; k < clip.reports.size(); ++k) {
    require(clip.reports[k - 1].frame < clip.reports[k].frame,
            fmt::format("frame {} comes after frame {}", clip.reports[k].frame, clip.reports[k - 1].frame));
  }
  require(clip.fps >= 1e-3 && clip.fps <= 1e6,
          fmt::format("a frame rate of {} frames a second is out of glTF's reach", clip.fps));
  check_mesh(clip.mesh);
  check_positions(clip.mesh.positions, "the rest mesh");
  for (std::size_t k = 0; k < clip.frames.size(); ++k) {
    const Positions& frame = clip.frames[k];
    require(frame.rows() == clip.mesh.vertex_count(), fmt::format("frame {} has {} vertices, the mesh has {}",
                                                                  k, frame.rows(), clip.mesh.vertex_count()));
    check_positions(frame, fmt::format("frame {}", k));
  }
}

void check_poses(const Clip& clip, const std::vector<PoseShape>& poses) {
  for (const PoseShape& pose : poses) {
    require(pose.positions.rows() == clip.mesh.vertex_count(),
            fmt::format("pose '{}' has {} vertices, the mesh has {}", pose.name, pose.positions.rows(),
                        clip.mesh.vertex_count()));
    check_positions(pose.positions, fmt::format("pose '{}'", pose.name));
  }
}

}  // namespace flexkey
