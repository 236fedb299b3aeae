#pragma once

#include <vector>

#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// A mesh with the vertices at one place made one: the surface that is solved. UV and normal seams of a file
/// split vertices that move together; what is solved on the surface is scattered back with `scatter`.
struct Weld {
  Mesh surface;  // same faces, groups, materials, creases and attributes; no texture coordinates
  std::vector<int> to_surface;  // #V of the file, surface vertex of each; first come, first numbered
};

/// distance: 0 welds equal positions only; else a vertex joins the first earlier one at most this far away.
Weld weld(const Mesh& mesh, double distance = 0);

/// Rows of the surface given back to the file's vertices: #V x 3.
Positions scatter(const Weld& weld, const Positions& surface_positions);

}  // namespace flexkey
