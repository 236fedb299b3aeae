#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace flexkey {

/// A triangle that a polygon is cut into, counted by its share: those of a polygon of n corners sum to n − 2.
struct FanTriangle {
  std::array<int, 3> corners;  // mesh vertices, in the polygon's order
  double share = 1;
};

/// The corners that a polygon is fanned from: all of them, or where that would cost too much an even choice
/// that begins at the lowest vertex, so that it does not depend on where the face begins.
std::vector<std::size_t> fan_roots(std::span<const int> face);

/// The triangles of a polygon's fans from all its roots, so that a quad counts with both its diagonals. A
/// triangle of a repeated corner is left out.
std::vector<FanTriangle> fan_triangles(std::span<const int> face);

}  // namespace flexkey
