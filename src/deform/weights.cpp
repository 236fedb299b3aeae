#include "flexkey/deform/weights.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "flexkey/deform/fans.h"

namespace flexkey {
namespace {

constexpr double clamp_share = 1e-6;  // of the mean weight

struct WeightedEdge {
  int low = 0, high = 0;
  double weight = 0;
};
using Edges = std::vector<WeightedEdge>;

bool by_ends(const WeightedEdge& a, const WeightedEdge& b) {
  return std::tie(a.low, a.high) < std::tie(b.low, b.high);
}

/// Sorted by one of their ends, in linear time; where that is the same they keep their order.
Edges sorted_by(int WeightedEdge::*end, const Edges& edges, int vertex_count) {
  std::vector<int> places(vertex_count + 1, 0);
  for (const WeightedEdge& edge : edges) ++places[edge.*end + 1];
  for (int v = 0; v < vertex_count; ++v) places[v + 1] += places[v];
  Edges sorted(edges.size());
  for (const WeightedEdge& edge : edges) sorted[places[edge.*end]++] = edge;
  return sorted;
}

/// One entry an edge, its weights summed. edges: sorted by (low, high).
Edges summed(Edges edges) {
  std::size_t kept = 0;
  for (const WeightedEdge& edge : edges) {
    if (kept > 0 && edges[kept - 1].low == edge.low && edges[kept - 1].high == edge.high) {
      edges[kept - 1].weight += edge.weight;
    } else {
      edges[kept++] = edge;
    }
  }
  edges.resize(kept);
  return edges;
}

/// The same of edges in any order.
Edges merged(const Edges& edges, int vertex_count) {
  const Edges by_high = sorted_by(&WeightedEdge::high, edges, vertex_count);
  return summed(sorted_by(&WeightedEdge::low, by_high, vertex_count));
}

WeightedEdge edge_between(int i, int j, double weight) {
  return {std::min(i, j), std::max(i, j), weight};
}

WeightedEdge opposite_edge(const WeightedTriangle& triangle, std::size_t k, double weight) {
  return edge_between(triangle.corners[(k + 1) % 3], triangle.corners[(k + 2) % 3], weight);
}

Edges cotangent_edges(const std::vector<WeightedTriangle>& triangles, int vertex_count) {
  Edges edges;
  edges.reserve(3 * triangles.size());
  for (const WeightedTriangle& triangle : triangles) {
    for (std::size_t k = 0; k < 3; ++k) edges.push_back(opposite_edge(triangle, k, triangle.weights[k]));
  }
  return merged(edges, vertex_count);
}

/// In how many triangles each edge lies, by their shares.
Edges edge_shares(const std::vector<WeightedTriangle>& triangles, int vertex_count) {
  Edges edges;
  edges.reserve(3 * triangles.size());
  for (const WeightedTriangle& triangle : triangles) {
    for (std::size_t k = 0; k < 3; ++k) edges.push_back(opposite_edge(triangle, k, triangle.share));
  }
  return merged(edges, vertex_count);
}

Edges uniform_edges(std::span<const int> face) {
  Edges edges;
  const std::size_t n = face.size();
  const std::vector<std::size_t> roots = fan_roots(face);
  for (std::size_t k = 0; k < n; ++k) edges.push_back(edge_between(face[k], face[(k + 1) % n], 1));
  for (const std::size_t root : roots) {
    for (std::size_t k = 2; k + 1 < n; ++k) {
      const double share = 1 / static_cast<double>(roots.size());
      edges.push_back(edge_between(face[root], face[(root + k) % n], share));
    }
  }
  std::erase_if(edges, [](const WeightedEdge& edge) { return edge.low == edge.high; });
  std::sort(edges.begin(), edges.end(), by_ends);
  return summed(std::move(edges));
}

/// Of all faces; a side of two of them is one edge of weight 1.
Edges uniform_edges(const Mesh& mesh) {
  Edges edges;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).size() < 3) continue;
    const Edges of_face = uniform_edges(mesh.face(f));
    edges.insert(edges.end(), of_face.begin(), of_face.end());
  }
  edges = merged(edges, mesh.vertex_count());
  for (WeightedEdge& edge : edges) edge.weight = std::min(edge.weight, 1.0);
  return edges;
}

/// The weights as they count: all but plain cotangents held above a floor.
Edges held(Edges edges, Weights weights) {
  if (weights == Weights::cotangent) return edges;
  double sum = 0;
  for (const WeightedEdge& edge : edges) sum += edge.weight;
  const double floor = clamp_share * sum / static_cast<double>(edges.size());
  for (WeightedEdge& edge : edges) edge.weight = std::max(edge.weight, floor);
  return edges;
}

/// `edges` sorted by (low, high), so that each cell's neighbours come out increasing.
Cells cells_of(const Edges& edges, int vertex_count) {
  Cells cells;
  cells.offsets.assign(vertex_count + 1, 0);
  for (const WeightedEdge& edge : edges) {
    ++cells.offsets[edge.low + 1];
    ++cells.offsets[edge.high + 1];
  }
  for (int i = 0; i < vertex_count; ++i) cells.offsets[i + 1] += cells.offsets[i];
  cells.edges.resize(2 * edges.size());
  std::vector<int> next(cells.offsets.begin(), cells.offsets.end() - 1);
  for (const WeightedEdge& edge : edges) cells.edges[next[edge.high]++] = {edge.low, edge.weight};
  for (const WeightedEdge& edge : edges) cells.edges[next[edge.low]++] = {edge.high, edge.weight};
  return cells;
}

}  // namespace

Cells build_cells(const Mesh& mesh, Weights weights) {
  if (weights == Weights::uniform) return cells_of(uniform_edges(mesh), mesh.vertex_count());
  const Edges edges = cotangent_edges(cotangent_triangles(mesh, weights), mesh.vertex_count());
  return cells_of(held(edges, weights), mesh.vertex_count());
}

std::vector<WeightedTriangle> build_triangles(const Mesh& mesh, Weights weights) {
  std::vector<WeightedTriangle> triangles = cotangent_triangles(mesh, weights);
  const Edges raw = cotangent_edges(triangles, mesh.vertex_count()), all = held(raw, weights);
  const Edges shares = edge_shares(triangles, mesh.vertex_count());
  for (WeightedTriangle& triangle : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at =
          std::lower_bound(raw.begin(), raw.end(), opposite_edge(triangle, k, 0), by_ends) - raw.begin();
      triangle.weights[k] += (all[at].weight - raw[at].weight) * triangle.share / shares[at].weight;
    }
  }
  return triangles;
}

}  // namespace flexkey
