#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace flexkey {

/// Triangles on one side of a split, with vertices of their own.
struct SplitSide {
  std::vector<int> triangles;          // their numbers in the primitive, increasing
  std::vector<int> vertices;           // rows of the primitive that they name, increasing
  std::vector<std::uint32_t> corners;  // 3 a triangle, rows of `vertices`
};

struct SplitFaces {
  SplitSide moving, still;
};

/// Parts the triangles that move from those that stay. A triangle moves with any of its corners, so that what
/// both sides name stays at rest on both. corners: 3 a triangle; moved: by row of the primitive.
SplitFaces split_faces(std::span<const std::uint32_t> corners, const std::vector<bool>& moved);

}  // namespace flexkey
