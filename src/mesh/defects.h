#pragma once

#include <string>
#include <vector>

#include "flexkey/mesh/connectivity.h"
#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// What is wrong with a mesh, though it can be read. Found on the welded surface, where seams are no borders.
struct Defects {
  std::vector<int> degenerate_faces;     // a vertex twice, or no area
  std::vector<int> duplicate_faces;      // the same vertices as an earlier face
  std::vector<Edge> non_manifold_edges;  // of more than two faces
  std::vector<Edge> flipped_edges;       // whose two faces run along them the same way
  std::vector<int> unreferenced_vertices;

  bool none() const {
    return degenerate_faces.empty() && duplicate_faces.empty() && non_manifold_edges.empty() &&
           flipped_edges.empty() && unreferenced_vertices.empty();
  }
};

Defects find_defects(const Mesh& mesh);

/// One line a kind of defect, with its count and first places: "3 degenerate faces (12, 40, 41)".
std::vector<std::string> describe(const Defects& defects);

}  // namespace flexkey
