#pragma once

#include <string>
#include <vector>

#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// The welded surface of a mesh as a subdivision scheme takes it: no seams, no unused vertices, no corner
/// that welding has put on its neighbour, no face that it has collapsed.
struct ControlMesh {
  Mesh mesh;                       // positions, faces and what is sharp
  std::vector<int> vertex_source;  // vertex of the file that each vertex is taken from
  std::vector<int> face_source;    // face of the file
  std::vector<int> corner_source;  // corner of the file
  std::vector<int> of_vertex;      // #V of the file, vertex or -1
};

/// Vertices of `mesh` at most `weld` apart become one.
ControlMesh control_mesh(const Mesh& mesh, double weld);

/// Why the mesh cannot be subdivided, and where in terms of the file; empty if it can. Schemes take
/// manifolds of one orientation only.
std::string subdivision_obstacle(const ControlMesh& control);

}  // namespace flexkey
