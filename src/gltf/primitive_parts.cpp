#include "flexkey/gltf/primitive_parts.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "flexkey/gltf/accessors.h"

namespace flexkey {
namespace {

/// The groups as [first, count, …] among these triangles alone, their numbers increasing.
std::vector<GltfGroup> groups_among(const std::vector<GltfGroup>& groups, const std::vector<int>& triangles) {
  std::vector<GltfGroup> result;
  for (const GltfGroup& group : groups) {
    GltfGroup among{group.name, {}};
    for (std::size_t run = 0; run + 2 <= group.triangles.size(); run += 2) {
      const std::int64_t begin = group.triangles[run], end = begin + group.triangles[run + 1];
      const auto first = std::lower_bound(triangles.begin(), triangles.end(), begin);
      const auto last = std::lower_bound(first, triangles.end(), end);
      if (first == last) continue;
      among.triangles.push_back(static_cast<int>(first - triangles.begin()));
      among.triangles.push_back(static_cast<int>(last - first));
    }
    if (!among.triangles.empty()) result.push_back(std::move(among));
  }
  return result;
}

}  // namespace

PrimitivePart compact_part(tinygltf::Model& model, const GltfPrimitive& primitive, const SplitSide& side,
                           const AccessorReader& reader) {
  PrimitivePart part;
  part.indices = append_triangles(model, side.corners);
  for (const auto& [semantic, accessor] : primitive.attributes)
    part.attributes[semantic] = append_elements(model, reader.elements(accessor, side.vertices));
  part.groups = groups_among(primitive.groups, side.triangles);
  return part;
}

PrimitivePart sharing_part(tinygltf::Model& model, const GltfPrimitive& primitive, const SplitSide& side) {
  std::vector<std::uint32_t> corners = side.corners;
  for (std::uint32_t& corner : corners) corner = static_cast<std::uint32_t>(side.vertices[corner]);
  PrimitivePart part;
  part.indices = append_triangles(model, corners);
  part.groups = groups_among(primitive.groups, side.triangles);
  return part;
}

}  // namespace flexkey
