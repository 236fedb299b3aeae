#pragma once

#include <cstdint>
#include <vector>

#include "flexkey/animate/clip.h"
#include "flexkey/gltf/primitives.h"

namespace flexkey {

/// What takes the space in a GLB.
struct GlbContents {
  std::int64_t frames = 0;
  std::int64_t primitives = 0;
  std::int64_t vertices = 0;  // of all primitives
  std::int64_t triangles = 0;
  std::int64_t texcoords = 0;    // vertices that have them
  std::int64_t moved = 0;        // vertices away from rest, summed over the frames
  std::int64_t turned = 0;       // vertices of faces with one of those, summed over the frames
  std::int64_t image_bytes = 0;  // of the embedded textures
  bool normals = false;
};

/// The longest GLB: its length field has 32 bits.
constexpr std::int64_t kMostGlbBytes = (std::int64_t{1} << 32) - 1;

/// Counts what the clip will take without building any of it; image_bytes and normals are the caller's.
GlbContents count_contents(const Clip& clip, const std::vector<Primitive>& primitives);

/// Bytes of the GLB, rather too many than too few: the arrays as they will be stored and a generous share of
/// JSON each.
std::int64_t estimate_glb_bytes(const GlbContents& contents);

/// Throws InputError, with the estimate in the message, where it is beyond `kMostGlbBytes`.
void check_glb_size(const GlbContents& contents);

}  // namespace flexkey
