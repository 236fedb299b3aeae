#pragma once

#include <array>
#include <vector>

#include "flexkey/mesh/types.h"

namespace flexkey::bench {

/// A triangulation of the unit sphere whose points can move and whose edges can be flipped.
///
/// Corner c = 3 t + k is the k-th of triangle t, counter-clockwise seen from outside; opposite_[c] is the
/// corner across the edge that lies opposite to c.
class SphereTriangulation {
 public:
  /// An octahedron whose faces are cut into size² triangles each.
  static SphereTriangulation octahedron(int size);

  int point_count() const { return static_cast<int>(points_.size()); }
  int triangle_count() const { return static_cast<int>(vertices_.size()) / 3; }
  const Vec3& point(int v) const { return points_[v]; }
  std::array<int, 3> triangle(int t) const {
    return {vertices_[3 * t], vertices_[3 * t + 1], vertices_[3 * t + 2]};
  }

  /// The corners of a vertex, in order around it.
  std::vector<int> corners_of(int v) const;
  double shortest_edge(int v) const;

  /// Moves a vertex there if that turns none of its triangles over.
  void move(int v, const Vec3& to);

  /// Flips edges until every triangle's circle is empty: the Delaunay triangulation of the points.
  void make_delaunay();

 private:
  static int next(int c) { return c - c % 3 + (c + 1) % 3; }
  static int previous(int c) { return c - c % 3 + (c + 2) % 3; }
  void find_opposites();
  void pair_up(int c, int d);
  bool should_flip(int c) const;
  void flip(int c);

  std::vector<Vec3> points_;
  std::vector<int> vertices_;  // #corners
  std::vector<int> opposite_;  // #corners
  std::vector<int> corner_;    // #points, one corner of each
};

}  // namespace flexkey::bench
