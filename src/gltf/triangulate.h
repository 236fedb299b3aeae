#pragma once

#include <array>
#include <vector>

#include "flexkey/mesh/types.h"

namespace flexkey {

/// Splits a polygon into triangles of its corners' indices, turning the same way round as the polygon.
/// corners: #corners x 3, in order around the polygon, at least 3.
/// A quad is cut along its shorter diagonal, or along the other where that one would fold a concave quad; a
/// larger polygon becomes a fan where a fan does not fold, else its ears are cut off one by one. Throws
/// InputError for a polygon of more than 10,000 corners that no fan can cover.
std::vector<std::array<int, 3>> triangulate(const Positions& corners);

}  // namespace flexkey
