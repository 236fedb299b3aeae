#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "flexkey/gltf/write_glb.h"

namespace flexkey::bench {

/// What one profile makes of a clip.
struct Written {
  GltfReport report;
  double seconds = 0;  // CPU, of the export
};

/// What gltfpack makes of the file of one target a frame, and `web` with that error as its tolerance.
struct Packed {
  std::string options;  // "-cc"
  double bytes = 0;
  double error = 0;  // largest vertex distance at any frame, a share of the diagonal
  Written web;
};

/// A clip's file sizes, bytes.
struct GltfResult {
  std::string name;
  int frames = 0;
  int vertices = 0;          // of the written primitives
  double solve_seconds = 0;  // CPU
  double dense = 0;          // one target a frame, positions and normals in floats, nothing sparse
  Written compat, web;
  // -cc, which plays frames of its own at 30 Hz; with -af 0, which keeps the clip's; and that with the fewest
  // bits (-vp) that stay within the default tolerance. None where gltfpack is not installed.
  std::vector<Packed> packed;
};

/// The blob of 10,002 vertices, bent by 90° and stretched by 30 % and back with an ease, in 100 and in 240
/// frames, and the sample shots nose, leg, jaw and twist.
std::vector<GltfResult> measure_gltf(const std::filesystem::path& timelines);

}  // namespace flexkey::bench
