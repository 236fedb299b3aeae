#pragma once

#include <array>
#include <vector>

#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// A triangle that lies in the surface, perhaps bent over its creases.
struct IntrinsicTriangle {
  std::array<int, 3> corners;     // distinct mesh vertices
  std::array<double, 3> lengths;  // along the surface, of the side opposite to each corner, mesh units
};

/// The intrinsic Delaunay triangulation of a surface: an edge whose opposite angles sum to more than 180
/// degrees is flipped within the surface, until there is none (Fisher, Springborn, Bobenko, Schröder, "An
/// Algorithm for the Construction of Intrinsic Delaunay Triangulations", 2006).
///
/// Polygons are first cut along their shortest diagonals, of equally short ones the one of the lowest vertex.
/// Kept as they are: edges of one face, of more than two, or of two faces that face opposite ways; and an
/// edge whose flip would join a vertex to itself. Lengths are drawn out where a triangle is flat (Sharp and
/// Crane, "A Laplacian for Nonmanifold Triangle Meshes", 2020, section 4.5). Flips stop at a fixed number,
/// which only broken surfaces reach.
std::vector<IntrinsicTriangle> intrinsic_delaunay(const Mesh& mesh);

/// Twice the area of a triangle of these sides (Heron's formula, as Kahan arranges it); 0 where they close no
/// triangle.
double double_area(const std::array<double, 3>& lengths);

}  // namespace flexkey
