#pragma once

#include <array>
#include <span>
#include <vector>

#include "flexkey/mesh/types.h"

namespace flexkey {

/// Cuts a polygon into the triangles of a fan, as places within `polygon` (vertices of `positions`). The fan
/// starts at the corner from which its triangles turn away least from the polygon's own normal, so that a
/// concave quad is cut along its inner diagonal.
std::vector<std::array<int, 3>> fan_of(std::span<const int> polygon, const Positions& positions);

}  // namespace flexkey
