#include "flexkey/preview/triangulate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace flexkey {
namespace {

std::vector<std::array<int, 3>> fan_from(int start, int corners) {
  std::vector<std::array<int, 3>> triangles;
  for (int k = 1; k + 1 < corners; ++k)
    triangles.push_back({start, (start + k) % corners, (start + k + 1) % corners});
  return triangles;
}

}  // namespace

std::vector<std::array<int, 3>> fan_of(std::span<const int> polygon, const Positions& positions) {
  const auto corners = static_cast<int>(polygon.size());
  if (corners == 3) return fan_from(0, corners);
  const auto at = [&](int k) { return Vec3(positions.row(polygon[static_cast<std::size_t>(k)])); };
  const auto area = [&](const std::array<int, 3>& t) -> Vec3 {
    return (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
  };
  Vec3 normal = Vec3::Zero();
  for (const auto& triangle : fan_from(0, corners)) normal += area(triangle);

  int best = 0;
  double best_area = -std::numeric_limits<double>::infinity();
  for (int start = 0; start < corners; ++start) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& triangle : fan_from(start, corners)) least = std::min(least, area(triangle).dot(normal));
    // A fan must be clearly better to be preferred, so that a flat square keeps its first diagonal.
    if (least <= best_area + 1e-9 * normal.squaredNorm()) continue;
    best = start;
    best_area = least;
  }
  return fan_from(best, corners);
}

}  // namespace flexkey
