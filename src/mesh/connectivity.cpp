#include "flexkey/mesh/connectivity.h"

#include <algorithm>
#include <map>

namespace flexkey {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

double length_of(const std::vector<int>& loop, const Positions& positions) {
  double length = 0;
  for (std::size_t k = 0; k < loop.size(); ++k)
    length += (positions.row(loop[k]) - positions.row(loop[(k + 1) % loop.size()])).norm();
  return length;
}

}  // namespace

std::vector<MeshEdge> mesh_edges(const Mesh& mesh) {
  std::vector<MeshEdge> edges;
  edges.reserve(mesh.corners.size());
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int a = face[k], b = face[(k + 1) % face.size()];
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : 0, a < b ? 0 : 1});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const MeshEdge& a, const MeshEdge& b) {
    return std::pair(a.low, a.high) < std::pair(b.low, b.high);
  });
  std::size_t kept = 0;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (kept > 0 && edges[kept - 1].low == edges[k].low && edges[kept - 1].high == edges[k].high) {
      edges[kept - 1].forward += edges[k].forward;
      edges[kept - 1].backward += edges[k].backward;
    } else {
      edges[kept++] = edges[k];
    }
  }
  edges.resize(kept);
  return edges;
}

Neighbours::Neighbours(const std::vector<MeshEdge>& edges, int vertex_count)
    : offsets_(index(vertex_count) + 1, 0), list_(2 * edges.size()) {
  for (const MeshEdge& edge : edges) {
    ++offsets_[index(edge.low) + 1];
    ++offsets_[index(edge.high) + 1];
  }
  for (std::size_t v = 1; v < offsets_.size(); ++v) offsets_[v] += offsets_[v - 1];
  std::vector<int> next(offsets_.begin(), offsets_.end() - 1);
  // Edges are sorted by (low, high), so one pass for each end leaves every list in increasing order.
  for (const MeshEdge& edge : edges) list_[index(next[index(edge.high)]++)] = edge.low;
  for (const MeshEdge& edge : edges) list_[index(next[index(edge.low)]++)] = edge.high;
}

Components find_components(const Mesh& mesh) {
  const Neighbours neighbours(mesh_edges(mesh), mesh.vertex_count());
  std::vector<bool> used(index(mesh.vertex_count()), false);
  for (const int v : mesh.corners) used[index(v)] = true;

  Components components;
  components.of_vertex.assign(index(mesh.vertex_count()), -1);
  std::vector<int> stack;
  for (int seed = 0; seed < mesh.vertex_count(); ++seed) {
    if (!used[index(seed)] || components.of_vertex[index(seed)] >= 0) continue;
    stack.assign(1, seed);
    components.of_vertex[index(seed)] = components.count;
    while (!stack.empty()) {
      const int v = stack.back();
      stack.pop_back();
      for (const int w : neighbours.of(v)) {
        if (components.of_vertex[index(w)] >= 0) continue;
        components.of_vertex[index(w)] = components.count;
        stack.push_back(w);
      }
    }
    ++components.count;
  }
  return components;
}

std::vector<std::vector<int>> boundary_loops(const Mesh& mesh) {
  std::multimap<int, int> next;  // along each border edge, as its one face runs
  for (const MeshEdge& edge : mesh_edges(mesh)) {
    if (edge.faces() != 1) continue;
    if (edge.forward == 1) {
      next.emplace(edge.low, edge.high);
    } else {
      next.emplace(edge.high, edge.low);
    }
  }
  std::vector<std::vector<int>> loops;
  while (!next.empty()) {
    std::vector<int> loop;
    for (auto step = next.begin(); step != next.end(); step = next.find(loop.back())) {
      const auto [from, to] = *step;
      next.erase(step);
      if (loop.empty()) loop.push_back(from);
      if (to == loop.front()) break;
      loop.push_back(to);
    }
    loops.push_back(std::move(loop));
  }
  std::stable_sort(loops.begin(), loops.end(), [&](const auto& a, const auto& b) {
    return length_of(a, mesh.positions) > length_of(b, mesh.positions);
  });
  return loops;
}

}  // namespace flexkey
