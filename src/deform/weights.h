#pragma once

#include <span>
#include <vector>

#include "flexkey/deform/cotangents.h"
#include "flexkey/deform/options.h"
#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// An edge of a cell: v_j, j in N(i), and ω_ij.
struct CellEdge {
  int neighbour = 0;
  double weight = 0;
};

/// The cells of a surface: each vertex i with its neighbours N(i), in compressed rows. ω_ij = ω_ji.
struct Cells {
  std::vector<int> offsets;     // #cells + 1
  std::vector<CellEdge> edges;  // by cell, neighbours increasing

  int count() const { return static_cast<int>(offsets.size()) - 1; }
  std::span<const CellEdge> of(int i) const {
    return {edges.data() + offsets[i], static_cast<std::size_t>(offsets[i + 1] - offsets[i])};
  }
};

/// The cells of all vertices with the weights of eq 1; a vertex of no triangle has an empty cell.
///
/// Cotangent weights are those of Meyer et al., ω_ij = (cot α + cot β)/2 with the angles opposite to the
/// edge. A polygon's are the mean over its triangle fans from every corner, a quad's over its two diagonals,
/// so its diagonals are edges too and the order of its corners does not matter. A triangle of a repeated
/// corner does not count. `clamped` holds each ω_ij at or above 1e-6 of their mean, and slivers at a double
/// area of 1/200 of their longest side squared; `cotangent` holds only what has no area to speak of (1e-4).
/// `intrinsic-delaunay` has those of the intrinsic Delaunay triangulation, held as `clamped` holds its own:
/// none is negative but at a border or another edge that it must keep, however obtuse the mesh. Its edges are
/// the cells', their lengths and angles measured in the surface, while e_ij stays p_i − p_j, straight through
/// space; several edges between the same two vertices count as one.
/// `uniform` is 1 for a side and 2/n for a diagonal of an n-gon.
Cells build_cells(const Mesh& mesh, Weights weights);

/// The triangles behind the cells' weights, which over the triangles of an edge sum to its ω_ij: what an edge
/// was held up by is given to its triangles in equal parts. weights: any but `uniform`.
std::vector<WeightedTriangle> build_triangles(const Mesh& mesh, Weights weights);

}  // namespace flexkey
