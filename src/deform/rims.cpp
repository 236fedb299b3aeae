#include "flexkey/deform/rims.h"

#include <algorithm>
#include <array>

namespace flexkey {
namespace {

/// The place in the patch of each mesh vertex that has triangles; behind its end where it is not in it.
std::vector<int> places(const std::vector<WeightedTriangle>& triangles, const Patch& patch) {
  int vertex_count = 0;
  for (const auto& [corners, weights, share] : triangles) {
    vertex_count = std::max({vertex_count, corners[0] + 1, corners[1] + 1, corners[2] + 1});
  }
  std::vector<int> place(vertex_count, patch.vertex_count());
  for (int i = 0; i < patch.vertex_count(); ++i) place[patch.vertices[i]] = i;
  return place;
}

/// A triangle (i, j, k) in patch numbering, seen from its corner i.
struct Corner {
  int i, j, k;
  double ij, jk, ki;  // weights of the edges
};

Corner corner_at(const WeightedTriangle& triangle, const std::vector<int>& place, std::size_t k) {
  const auto& [corners, weights, share] = triangle;
  const std::size_t second = (k + 1) % 3, third = (k + 2) % 3;
  return {place[corners[k]], place[corners[second]], place[corners[third]], weights[third],
          weights[k],        weights[second]};
}

/// The row of the directed edge from i to its neighbour j.
int edge_row(const CellTables& tables, int i, int j) {
  const auto begin = tables.neighbours.begin();
  const auto found = std::find(begin + tables.offsets[i], begin + tables.offsets[i + 1], j);
  return static_cast<int>(found - begin);
}

/// A third of a triangle's edges belongs to each of its cells; twice that, since a spoke counts from both its
/// ends.
constexpr double cell_share = 2.0 / 3;

void add_to_fit(const Corner& at, const Positions& rest, CellTables& tables) {
  const auto& [i, j, k, ij, jk, ki] = at;
  const Vec3 e_ij = rest.row(i) - rest.row(j), e_jk = rest.row(j) - rest.row(k);
  const Vec3 e_ki = rest.row(k) - rest.row(i);
  // e′_jk = (p′_i − p′_k) − (p′_i − p′_j) makes the rim part of both its ends.
  tables.edges.row(edge_row(tables, i, j)) += cell_share * (ij * e_ij - jk * e_jk);
  tables.edges.row(edge_row(tables, i, k)) += cell_share * (jk * e_jk - ki * e_ki);
  add_moments(e_ij, cell_share * ij, tables.moments, i);
  add_moments(e_jk, cell_share * jk, tables.moments, i);
  add_moments(e_ki, cell_share * ki, tables.moments, i);
}

/// A triangle's part of δ_i, turned by the mean of its three rotations.
void add_to_pulls(const Corner& at, const Positions& rest, CellTables& tables) {
  const auto& [i, j, k, ij, jk, ki] = at;
  const Vec3 delta = ij * (rest.row(i) - rest.row(j)) + ki * (rest.row(i) - rest.row(k));
  tables.pulls.row(edge_row(tables, i, j)) += delta / 2;
  tables.pulls.row(edge_row(tables, i, k)) += delta / 2;
}

}  // namespace

void add_rims(const std::vector<WeightedTriangle>& triangles, const Patch& patch, CellTables& tables) {
  const std::vector<int> place = places(triangles, patch);
  tables.edges.setZero();
  tables.pulls = Positions::Zero(tables.edges.rows(), 3);
  tables.own = 1.0 / 3;
  tables.moments = no_moments(patch.fitted);
  for (const WeightedTriangle& triangle : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner at = corner_at(triangle, place, k);
      if (at.i >= patch.fitted) continue;
      add_to_fit(at, patch.rest, tables);
      add_to_pulls(at, patch.rest, tables);
    }
  }
}

}  // namespace flexkey
