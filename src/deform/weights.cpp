#include "flexkey/deform/weights.h"

#include <Eigen/Geometry>
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

/// One entry an edge, its weights summed.
Edges merged(Edges edges) {
  std::sort(edges.begin(), edges.end(), [](const WeightedEdge& a, const WeightedEdge& b) {
    return std::tie(a.low, a.high) < std::tie(b.low, b.high);
  });
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

WeightedEdge edge_between(int i, int j, double weight) {
  return {std::min(i, j), std::max(i, j), weight};
}

/// The least thickness that a triangle counts with: its double area over its longest side squared. Stiffer
/// slivers would drown their cells: with a few percent of them λ = 0 no longer converges.
double least_thickness(Weights weights) {
  return weights == Weights::clamped ? 5e-3 : 1e-4;
}

/// The cotangents at three corners, their triangle held at the least thickness. Scaling all three alike
/// keeps the triangle's share of L positive semidefinite.
std::array<double, 3> cotangents(const Vec3& a, const Vec3& b, const Vec3& c, double thickness) {
  const Vec3 ab = b - a, bc = c - b, ca = a - c;
  const double longest = std::max({ab.squaredNorm(), bc.squaredNorm(), ca.squaredNorm()});
  if (longest == 0) return {0, 0, 0};
  const double double_area = std::max(ab.cross(ca).norm(), thickness * longest);
  return {-ab.dot(ca) / double_area, -bc.dot(ab) / double_area, -ca.dot(bc) / double_area};
}

Edges cotangent_edges(const Positions& p, std::span<const int> face, double thickness) {
  Edges edges;
  for (const auto& [corners, share] : fan_triangles(face)) {
    const auto [a, b, c] = corners;
    const auto [cot_a, cot_b, cot_c] = cotangents(p.row(a), p.row(b), p.row(c), thickness);
    edges.push_back(edge_between(b, c, 0.5 * share * cot_a));
    edges.push_back(edge_between(c, a, 0.5 * share * cot_b));
    edges.push_back(edge_between(a, b, 0.5 * share * cot_c));
  }
  return merged(std::move(edges));
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
  return merged(std::move(edges));
}

Edges weighted_edges(const Mesh& mesh, Weights weights) {
  Edges edges;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    if (face.size() < 3) continue;
    const Edges of_face = weights == Weights::uniform
                              ? uniform_edges(face)
                              : cotangent_edges(mesh.positions, face, least_thickness(weights));
    edges.insert(edges.end(), of_face.begin(), of_face.end());
  }
  return merged(std::move(edges));
}

void hold_above_floor(Edges& edges) {
  double sum = 0;
  for (const WeightedEdge& edge : edges) sum += edge.weight;
  const double floor = clamp_share * sum / static_cast<double>(edges.size());
  for (WeightedEdge& edge : edges) edge.weight = std::max(edge.weight, floor);
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
  Edges edges = weighted_edges(mesh, weights);
  if (weights == Weights::clamped) hold_above_floor(edges);
  if (weights == Weights::uniform) {
    for (WeightedEdge& edge : edges)
      edge.weight = std::min(edge.weight, 1.0);  // a side of two faces is one edge
  }
  return cells_of(edges, mesh.vertex_count());
}

}  // namespace flexkey
