#pragma once

#include <Eigen/Core>

#include "flexkey/mesh/mesh.h"

namespace flexkey::cli {

/// How a surface lies in space.
struct PrincipalAxes {
  Vec3 centre;           // of its area
  Eigen::Matrix3d axes;  // columns, unit, the longest first
  Vec3 extents;          // of its vertices along them, mesh units

  bool is_long() const { return extents[0] >= 2 * extents[1]; }
  bool is_flat() const { return extents[2] < 0.2 * extents[1]; }
};

/// Of the faces whose vertices are all `taken` (#V). Where the surface has no clear axes of its own (a cube,
/// a sphere), and where they nearly are the coordinate axes, these are taken. Throws InputError if it has no
/// area.
PrincipalAxes principal_axes(const Mesh& surface, const std::vector<bool>& taken);

}  // namespace flexkey::cli
