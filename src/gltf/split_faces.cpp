#include "flexkey/gltf/split_faces.h"

#include <algorithm>

namespace flexkey {
namespace {

/// Gives the side the vertices that its corners name; the corners are rows of the primitive until then.
void take_vertices(SplitSide& side) {
  side.vertices.assign(side.corners.begin(), side.corners.end());
  std::sort(side.vertices.begin(), side.vertices.end());
  side.vertices.erase(std::unique(side.vertices.begin(), side.vertices.end()), side.vertices.end());
  for (std::uint32_t& corner : side.corners) {
    const auto found = std::lower_bound(side.vertices.begin(), side.vertices.end(), static_cast<int>(corner));
    corner = static_cast<std::uint32_t>(found - side.vertices.begin());
  }
}

}  // namespace

SplitFaces split_faces(std::span<const std::uint32_t> corners, const std::vector<bool>& moved) {
  SplitFaces faces;
  for (std::size_t first = 0; first + 3 <= corners.size(); first += 3) {
    const auto triangle = corners.subspan(first, 3);
    const bool moves = std::any_of(triangle.begin(), triangle.end(), [&](auto v) { return moved[v]; });
    SplitSide& side = moves ? faces.moving : faces.still;
    side.triangles.push_back(static_cast<int>(first / 3));
    side.corners.insert(side.corners.end(), triangle.begin(), triangle.end());
  }
  take_vertices(faces.moving);
  take_vertices(faces.still);
  return faces;
}

}  // namespace flexkey
