#include "flexkey/deform/patch.h"

#include <algorithm>

namespace flexkey {
namespace {

/// Numbers vertices in the order in which they are added.
class Numbering {
 public:
  explicit Numbering(int mesh_vertex_count) : number_(mesh_vertex_count, -1) {}

  void add(int vertex) {
    if (number_[vertex] >= 0) return;
    number_[vertex] = count();
    vertices_.push_back(vertex);
  }

  /// Adds the neighbours of the first `count` vertices, in increasing order.
  void add_ring(const Cells& cells, int count) {
    std::vector<int> ring;
    for (int i = 0; i < count; ++i) {
      for (const auto [j, weight] : cells.of(vertices_[i])) {
        if (number_[j] < 0) ring.push_back(j);
      }
    }
    std::sort(ring.begin(), ring.end());
    for (const int vertex : ring) add(vertex);
  }

  int count() const { return static_cast<int>(vertices_.size()); }
  int of(int vertex) const { return number_[vertex]; }
  const std::vector<int>& vertices() const { return vertices_; }

 private:
  std::vector<int> number_;  // of each mesh vertex, or -1
  std::vector<int> vertices_;
};

Cells renumbered(const Cells& cells, const Numbering& numbering, int count) {
  Cells result;
  result.offsets.push_back(0);
  for (int i = 0; i < count; ++i) {
    for (const auto [j, weight] : cells.of(numbering.vertices()[i])) {
      result.edges.push_back({numbering.of(j), weight});
    }
    result.offsets.push_back(static_cast<int>(result.edges.size()));
  }
  return result;
}

}  // namespace

Patch make_patch(const Cells& cells, const Positions& rest, const std::vector<bool>& is_free, System system) {
  Numbering numbering(cells.count());
  for (int v = 0; v < cells.count(); ++v) {
    if (is_free[v]) numbering.add(v);
  }
  Patch patch;
  patch.free = numbering.count();
  if (system == System::least_squares) numbering.add_ring(cells, patch.free);
  patch.rows = numbering.count();
  numbering.add_ring(cells, patch.rows);
  patch.fitted = numbering.count();
  numbering.add_ring(cells, patch.fitted);
  patch.vertices = numbering.vertices();
  patch.cells = renumbered(cells, numbering, patch.fitted);
  patch.rest = rest(patch.vertices, Eigen::all);
  return patch;
}

}  // namespace flexkey
