#include "flexkey/gltf/split_asset.h"

#include <algorithm>

#include "flexkey/gltf/split_faces.h"

namespace flexkey {
namespace {

int vertex_count(const std::vector<Primitive>& primitives) {
  std::size_t count = 0;
  for (const Primitive& primitive : primitives) count += primitive.vertices.size();
  return static_cast<int>(count);
}

std::vector<int> picked(const std::vector<int>& values, const std::vector<int>& places) {
  std::vector<int> result;
  for (const int place : places) result.push_back(values[static_cast<std::size_t>(place)]);
  return result;
}

/// Adds the side as a primitive, unless it is empty.
void add_side(std::vector<Primitive>& primitives, const Primitive& primitive, SplitSide side) {
  if (side.triangles.empty()) return;
  Primitive part;
  part.material = primitive.material;
  part.vertices = picked(primitive.vertices, side.vertices);
  if (!primitive.texcoords.empty()) part.texcoords = picked(primitive.texcoords, side.vertices);
  part.triangles = std::move(side.corners);
  part.faces = picked(primitive.faces, side.triangles);
  primitives.push_back(std::move(part));
}

}  // namespace

AssetSplit whole(const Asset& asset) {
  AssetSplit split;
  split.moving = asset.primitives;
  split.note.mesh = asset.clip.name;
  split.note.vertices = split.note.targeted = vertex_count(split.moving);
  return split;
}

AssetSplit split_asset(const Asset& asset, const std::vector<bool>& moved) {
  AssetSplit split;
  split.note = whole(asset).note;
  for (const Primitive& primitive : asset.primitives) {
    std::vector<bool> rows;
    for (const int v : primitive.vertices) rows.push_back(moved[static_cast<std::size_t>(v)]);
    split.note.moved += static_cast<int>(std::count(rows.begin(), rows.end(), true));
    SplitFaces faces = split_faces(primitive.triangles, rows);
    add_side(split.moving, primitive, std::move(faces.moving));
    add_side(split.still, primitive, std::move(faces.still));
  }
  split.note.targeted = vertex_count(split.moving);
  split.note = split.moving.empty() ? left_whole(split.note, "nothing moves") : decide_split(split.note);
  if (split.note.why_whole.empty()) return split;
  return {asset.primitives, {}, split.note};
}

}  // namespace flexkey
