#pragma once

#include <span>
#include <utility>
#include <vector>

#include "flexkey/mesh/mesh.h"

namespace flexkey {

using Edge = std::pair<int, int>;  // vertex indices

/// An undirected edge of the polygons and how many faces run along it each way.
struct MeshEdge {
  int low = 0, high = 0;  // low < high
  int forward = 0;        // faces that run low -> high
  int backward = 0;       // faces that run high -> low
  int faces() const { return forward + backward; }
};

/// The edges around all polygons, sorted by (low, high); an edge from a vertex to itself is left out.
std::vector<MeshEdge> mesh_edges(const Mesh& mesh);

/// The neighbours of each vertex along `edges`, in increasing order.
class Neighbours {
 public:
  Neighbours(const std::vector<MeshEdge>& edges, int vertex_count);
  std::span<const int> of(int vertex) const {
    const auto first = static_cast<std::size_t>(offsets_[static_cast<std::size_t>(vertex)]);
    const auto last = static_cast<std::size_t>(offsets_[static_cast<std::size_t>(vertex) + 1]);
    return {list_.data() + first, last - first};
  }

 private:
  std::vector<int> offsets_, list_;
};

/// Connected components, numbered by their lowest vertex.
struct Components {
  std::vector<int> of_vertex;  // #V, component or -1 for a vertex of no face
  int count = 0;
};
Components find_components(const Mesh& mesh);

/// The loops of edges with one face, each as its vertices in order; longest by length first. A chain that
/// does not close (at a non-manifold vertex) is given as it is.
std::vector<std::vector<int>> boundary_loops(const Mesh& mesh);

}  // namespace flexkey
