#pragma once

#include <vector>

#include "flexkey/deform/options.h"
#include "flexkey/deform/weights.h"
#include "flexkey/mesh/types.h"

namespace flexkey {

/// The part of the surface that a solve touches, numbered so that every set of the method is a leading range:
/// the unknowns F, then the rows, then the fitted cells, then their fixed neighbours.
struct Patch {
  std::vector<int> vertices;  // mesh vertex of each patch vertex
  int free = 0;               // F: the region's vertices that are not held
  int rows = 0;               // F, and under eq 7 the fixed vertices with a neighbour in F: eq 4 holds here
  int fitted = 0;             // the rows and their neighbours: eq 4 needs R_i and S_i here
  Cells cells;                // whole cells of the fitted vertices, in patch numbering
  Positions rest;             // #vertices x 3

  int vertex_count() const { return static_cast<int>(vertices.size()); }
};

/// is_free: #V, whether a vertex is an unknown; an unknown has a cell.
Patch make_patch(const Cells& cells, const Positions& rest, const std::vector<bool>& is_free, System system);

}  // namespace flexkey
