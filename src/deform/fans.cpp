#include "flexkey/deform/fans.h"

#include <algorithm>

namespace flexkey {
namespace {

constexpr std::size_t most_fans = 64;  // a polygon of n corners costs n times its fans

}  // namespace

std::vector<std::size_t> fan_roots(std::span<const int> face) {
  const std::size_t n = face.size(), count = std::min(n, most_fans);
  const auto lowest = static_cast<std::size_t>(std::min_element(face.begin(), face.end()) - face.begin());
  std::vector<std::size_t> roots(count);
  for (std::size_t k = 0; k < count; ++k) roots[k] = (lowest + k * n / count) % n;
  return roots;
}

std::vector<FanTriangle> fan_triangles(std::span<const int> face) {
  std::vector<FanTriangle> triangles;
  if (face.size() < 3) return triangles;
  std::vector<std::size_t> roots = fan_roots(face);
  if (face.size() == 3) roots.resize(1);  // every fan is the triangle itself
  triangles.reserve(roots.size() * (face.size() - 2));
  for (const std::size_t root : roots) {
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      const int a = face[root], b = face[(root + k) % face.size()], c = face[(root + k + 1) % face.size()];
      if (a == b || b == c || c == a) continue;
      triangles.push_back({{a, b, c}, 1 / static_cast<double>(roots.size())});
    }
  }
  return triangles;
}

}  // namespace flexkey
