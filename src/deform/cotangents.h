#pragma once

#include <array>
#include <vector>

#include "flexkey/deform/options.h"
#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// A triangle of the surface and its part of the weights of its edges.
struct WeightedTriangle {
  std::array<int, 3> corners;     // distinct mesh vertices
  std::array<double, 3> weights;  // of the edge opposite to each corner
  double share = 1;               // what it counts, as one of the triangles that a polygon may be cut into
};

/// The triangles of a surface with half their cotangents, times their share: the weights of Meyer et al. are
/// their sums over an edge's triangles. Slivers are held as build_cells says.
/// weights: any but `uniform`, which has no cotangents.
std::vector<WeightedTriangle> cotangent_triangles(const Mesh& mesh, Weights weights);

}  // namespace flexkey
