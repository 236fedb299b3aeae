#include "flexkey/gltf/primitive_faces.h"

#include <algorithm>
#include <cstddef>

namespace flexkey {

std::vector<std::array<int, 3>> triangles_of_mode(const std::vector<int>& corners, int mode) {
  constexpr int list = 4, strip = 5, fan = 6;
  std::vector<std::array<int, 3>> triangles;
  if (mode == list) {
    for (std::size_t c = 0; c + 3 <= corners.size(); c += 3)
      triangles.push_back({corners[c], corners[c + 1], corners[c + 2]});
  } else if (mode == strip) {
    // Every other triangle has its last two corners exchanged, glTF 2.0 section 3.7.2.1.
    for (std::size_t c = 0; c + 3 <= corners.size(); ++c)
      triangles.push_back({corners[c], corners[c + 1 + c % 2], corners[c + 2 - c % 2]});
  } else if (mode == fan) {
    for (std::size_t c = 1; c + 2 <= corners.size(); ++c)
      triangles.push_back({corners[c], corners[c + 1], corners[0]});
  }
  if (mode != list)
    std::erase_if(triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  return triangles;
}

}  // namespace flexkey
