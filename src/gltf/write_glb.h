#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "flexkey/animate/clip.h"

namespace flexkey {

struct GltfOptions {
  bool normals = true;  // write smooth normals and their deltas; else none, and clients shade flat
  std::string hash;     // of timeline and mesh, for extras
  std::filesystem::path
      texture_folder;     // where relative texture paths of materials start: the mesh file's folder
  int max_targets = 200;  // frames beyond are an error; WebGL2 guarantees 256
};

struct GltfReport {
  std::uintmax_t bytes = 0;
  int targets = 0;   // morph targets a mesh primitive
  int vertices = 0;  // of all primitives, after splitting along UV and material seams
  double error =
      0;  // largest vertex distance from the solved frames, read back, as a share of the rest diagonal
  double kg_error = 0;              // percent
  double normal_error_mean = 0;     // degrees, likewise
  double normal_error_largest = 0;  // degrees
  std::vector<std::string> warnings;
};

/// Writes the clip as a GLB: the rest mesh, one morph target a frame, LINEAR weights (profile `exact`).
/// One primitive a material; polygons become triangles; textures that are there as PNG or JPEG are embedded.
/// Written beside `path` and renamed when whole. Throws OutputError, and InputError for what glTF cannot
/// hold.
GltfReport write_glb(const Clip& clip, const GltfOptions& options, const std::filesystem::path& path);

}  // namespace flexkey
