#pragma once

#include <array>
#include <vector>

namespace flexkey {

/// The triangles of a glTF primitive's vertices, all turning the same way; mode as OpenGL numbers it: 4
/// triangles, 5 strip, 6 fan, none of points and lines. Corners that are left over at the end are dropped,
/// and so are a strip's and a fan's triangles that name a vertex twice, with which they turn back.
std::vector<std::array<int, 3>> triangles_of_mode(const std::vector<int>& corners, int mode);

}  // namespace flexkey
