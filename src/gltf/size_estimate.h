#pragma once

#include <cstdint>

#include "flexkey/gltf/asset.h"
#include "flexkey/gltf/targets.h"

namespace flexkey {

/// What takes the space in a GLB.
struct GlbContents {
  std::int64_t frames = 0;
  std::int64_t targets = 0;
  std::int64_t primitives = 0;
  std::int64_t vertices = 0;  // of all primitives
  std::int64_t triangles = 0;
  std::int64_t texcoords = 0;    // vertices that have them
  std::int64_t moved = 0;        // vertices with a position delta, summed over the targets
  std::int64_t turned = 0;       // vertices with a normal delta, summed over the targets
  std::int64_t image_bytes = 0;  // of the embedded textures
  bool normals = false;
};

/// The longest GLB: its length field has 32 bits.
constexpr std::int64_t kMostGlbBytes = (std::int64_t{1} << 32) - 1;

/// Counts what the file will take without building any of it.
GlbContents count_contents(const Asset& asset, const MorphTargets& targets);

/// Bytes of the GLB, rather too many than too few: the arrays as floats and a generous share of JSON each.
std::int64_t estimate_glb_bytes(const GlbContents& contents);

/// Throws InputError, with the estimate in the message, where it is beyond `kMostGlbBytes`.
void check_glb_size(const GlbContents& contents);

}  // namespace flexkey
