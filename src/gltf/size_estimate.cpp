#include "flexkey/gltf/size_estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "flexkey/gltf/float_rows.h"
#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

// Bytes of JSON: an accessor with its bounds and up to three buffer views; what the extras say of a frame, in
// the mesh and in the animation; a primitive with its material.
constexpr std::int64_t kAccessorJson = 700;
constexpr std::int64_t kFrameJson = 160;
constexpr std::int64_t kPrimitiveJson = 4000;

/// Rows that are not all zero, a row counted for each of the primitives' vertices that has it.
std::int64_t nonzero_count(const std::vector<FloatRows>& targets, const std::vector<Primitive>& primitives) {
  std::int64_t count = 0;
  for (const FloatRows& rows : targets) {
    const Eigen::VectorX<bool> nonzero = (rows.array() != 0.0F).rowwise().any();
    for (const Primitive& primitive : primitives) {
      for (const int v : primitive.vertices) count += nonzero[v];
    }
  }
  return count;
}

/// All targets of one attribute. Each is sparse where that is smaller, so together they take at most what
/// they would all dense or all sparse.
std::int64_t target_bytes(const GlbContents& contents, std::int64_t kept) {
  const std::int64_t targets = contents.targets * contents.primitives;
  const std::int64_t dense = dense_bytes(contents.vertices * contents.targets, 3);
  const std::int64_t sparse = sparse_bytes(kept + targets, contents.vertices, 3) + 4 * targets;
  return std::min(dense, sparse) + targets * kAccessorJson;
}

}  // namespace

GlbContents count_contents(const Asset& asset, const MorphTargets& targets) {
  GlbContents contents;
  contents.frames = static_cast<std::int64_t>(asset.clip.frames.size());
  contents.targets = static_cast<std::int64_t>(targets.positions.size());
  contents.primitives = static_cast<std::int64_t>(asset.primitives.size());
  for (const Primitive& primitive : asset.primitives) {
    contents.vertices += static_cast<std::int64_t>(primitive.vertices.size());
    contents.triangles += static_cast<std::int64_t>(primitive.faces.size());
    contents.texcoords += static_cast<std::int64_t>(primitive.texcoords.size());
  }
  contents.moved = nonzero_count(targets.positions, asset.primitives);
  contents.turned = nonzero_count(targets.normals, asset.primitives);
  contents.normals = asset.normals.has_value();
  for (const Texture& texture : asset.textures.textures) {
    contents.image_bytes += static_cast<std::int64_t>(texture.bytes.size());
  }
  return contents;
}

std::int64_t estimate_glb_bytes(const GlbContents& contents) {
  const std::int64_t frames = contents.frames, samples = contents.frames * contents.targets;
  const std::int64_t positions = dense_bytes(contents.vertices, 3);
  std::int64_t bytes = positions + dense_bytes(contents.texcoords, 2) + 12 * contents.triangles;
  bytes += target_bytes(contents, contents.moved);
  if (contents.normals) bytes += positions + target_bytes(contents, contents.turned);
  bytes += dense_bytes(frames, 1);
  bytes += std::min(dense_bytes(samples, 1), sparse_bytes(frames, samples, 1));
  bytes += contents.image_bytes;
  return bytes + frames * kFrameJson + contents.primitives * kPrimitiveJson + kPrimitiveJson;
}

void check_glb_size(const GlbContents& contents) {
  const std::int64_t bytes = estimate_glb_bytes(contents);
  if (bytes <= kMostGlbBytes) return;
  throw InputError(
      fmt::format("the GLB would take about {:.1f} GiB, and a GLB cannot reach 4 GiB; write fewer frames, "
                  "allow a larger tolerance or leave out the normals",
                  static_cast<double>(bytes) / (1 << 30)));
}

}  // namespace flexkey
