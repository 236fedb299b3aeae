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

/// Whether each vertex is somewhere else than at rest, once rounded to floats.
std::vector<char> moved_vertices(const Positions& rest, const Positions& frame) {
  std::vector<char> moved;
  for (Eigen::Index v = 0; v < rest.rows(); ++v) {
    moved.push_back(rest.row(v).cast<float>() != frame.row(v).cast<float>());
  }
  return moved;
}

/// The vertices of all faces that have a moved one.
std::vector<char> turned_vertices(const Mesh& mesh, const std::vector<char>& moved) {
  const auto has_moved = [&](int v) { return moved[static_cast<std::size_t>(v)] != 0; };
  std::vector<char> turned = moved;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    if (!std::any_of(face.begin(), face.end(), has_moved)) continue;
    for (const int v : face) turned[static_cast<std::size_t>(v)] = 1;
  }
  return turned;
}

std::int64_t count_in(const std::vector<Primitive>& primitives, const std::vector<char>& flags) {
  std::int64_t count = 0;
  for (const Primitive& primitive : primitives) {
    for (const int v : primitive.vertices) count += flags[static_cast<std::size_t>(v)];
  }
  return count;
}

/// All targets of one attribute. Each is sparse where that is smaller, so together they take at most what
/// they would all dense or all sparse.
std::int64_t target_bytes(const GlbContents& contents, std::int64_t kept) {
  const std::int64_t targets = contents.frames * contents.primitives;
  const std::int64_t dense = dense_bytes(contents.vertices * contents.frames, 3);
  const std::int64_t sparse = sparse_bytes(kept + targets, contents.vertices, 3) + 4 * targets;
  return std::min(dense, sparse) + targets * kAccessorJson;
}

}  // namespace

GlbContents count_contents(const Clip& clip, const std::vector<Primitive>& primitives) {
  GlbContents contents;
  contents.frames = static_cast<std::int64_t>(clip.frames.size());
  contents.primitives = static_cast<std::int64_t>(primitives.size());
  for (const Primitive& primitive : primitives) {
    contents.vertices += static_cast<std::int64_t>(primitive.vertices.size());
    contents.triangles += static_cast<std::int64_t>(primitive.faces.size());
    contents.texcoords += static_cast<std::int64_t>(primitive.texcoords.size());
  }
  for (const Positions& frame : clip.frames) {
    const std::vector<char> moved = moved_vertices(clip.mesh.positions, frame);
    contents.moved += count_in(primitives, moved);
    contents.turned += count_in(primitives, turned_vertices(clip.mesh, moved));
  }
  return contents;
}

std::int64_t estimate_glb_bytes(const GlbContents& contents) {
  const std::int64_t frames = contents.frames;
  const std::int64_t positions = dense_bytes(contents.vertices, 3);
  std::int64_t bytes = positions + dense_bytes(contents.texcoords, 2) + 12 * contents.triangles;
  bytes += target_bytes(contents, contents.moved);
  if (contents.normals) bytes += positions + target_bytes(contents, contents.turned);
  bytes += dense_bytes(frames, 1);
  bytes += std::min(dense_bytes(frames * frames, 1), sparse_bytes(frames, frames * frames, 1));
  bytes += contents.image_bytes;
  return bytes + frames * kFrameJson + contents.primitives * kPrimitiveJson + kPrimitiveJson;
}

void check_glb_size(const GlbContents& contents) {
  const std::int64_t bytes = estimate_glb_bytes(contents);
  if (bytes <= kMostGlbBytes) return;
  throw InputError(fmt::format(
      "the GLB would take about {:.1f} GiB, and a GLB cannot reach 4 GiB; write fewer frames or no normals",
      static_cast<double>(bytes) / (1 << 30)));
}

}  // namespace flexkey
