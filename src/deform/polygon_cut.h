#pragma once

#include <array>
#include <span>
#include <vector>

#include "flexkey/mesh/types.h"

namespace flexkey {

/// Cuts a polygon into triangles of distinct corners, in its order: again and again the corner goes whose
/// neighbours are nearest to each other, of equally near ones those of the lowest vertex. So it does not
/// matter at which corner the polygon begins.
std::vector<std::array<int, 3>> cut_polygon(const Positions& positions, std::span<const int> face);

}  // namespace flexkey
