#include "sphere_triangulation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <utility>

namespace flexkey::bench {
namespace {

using Lattice = std::array<int, 3>;  // a point of the grid, |x| + |y| + |z| = size

/// Six times the volume of the tetrahedron; positive where d lies on the outer side of a, b, c.
double height(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

bool faces_outwards(const Vec3& a, const Vec3& b, const Vec3& c) {
  return a.dot(b.cross(c)) > 0;
}

/// Numbers lattice points as they come and lays them on the sphere.
class GridPoints {
 public:
  int number(const Lattice& at) {
    const auto [place, is_new] = numbers_.try_emplace(at, static_cast<int>(points_.size()));
    if (is_new) points_.push_back(Vec3(at[0], at[1], at[2]).normalized());
    return place->second;
  }
  std::vector<Vec3> take() { return std::move(points_); }

 private:
  std::map<Lattice, int> numbers_;
  std::vector<Vec3> points_;
};

/// The triangles of the octahedron's face in one octant: those that point to its corners' sum, and those
/// upside down between them.
std::vector<std::array<Lattice, 3>> octant(int size, const Lattice& sign) {
  std::vector<std::array<Lattice, 3>> triangles;
  const auto add = [&](Lattice a, Lattice b, Lattice c) {
    for (Lattice* at : {&a, &b, &c}) {
      for (std::size_t k = 0; k < 3; ++k) (*at)[k] *= sign[k];
    }
    if (sign[0] * sign[1] * sign[2] < 0) std::swap(b, c);
    triangles.push_back({a, b, c});
  };
  for (int x = 0; x < size; ++x) {
    for (int y = 0; x + y < size; ++y) {
      const int z = size - 1 - x - y;
      add({x + 1, y, z}, {x, y + 1, z}, {x, y, z + 1});
      if (z > 0) add({x, y + 1, z}, {x + 1, y, z}, {x + 1, y + 1, z - 1});
    }
  }
  return triangles;
}

}  // namespace

SphereTriangulation SphereTriangulation::octahedron(int size) {
  SphereTriangulation sphere;
  GridPoints grid;
  for (const int x : {1, -1}) {
    for (const int y : {1, -1}) {
      for (const int z : {1, -1}) {
        for (const auto& triangle : octant(size, {x, y, z})) {
          for (const Lattice& at : triangle) sphere.vertices_.push_back(grid.number(at));
        }
      }
    }
  }
  sphere.points_ = grid.take();
  sphere.find_opposites();
  return sphere;
}

void SphereTriangulation::find_opposites() {
  struct Side {
    std::pair<int, int> edge;  // the smaller vertex first
    int corner = 0;            // that it lies opposite to
  };
  std::vector<Side> sides;
  corner_.resize(points_.size());
  for (int c = 0; c < static_cast<int>(vertices_.size()); ++c) {
    sides.push_back({std::minmax({vertices_[next(c)], vertices_[previous(c)]}), c});
    corner_[vertices_[c]] = c;
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.edge < b.edge; });
  opposite_.resize(vertices_.size());
  for (std::size_t k = 0; k + 1 < sides.size(); k += 2) pair_up(sides[k].corner, sides[k + 1].corner);
}

std::vector<int> SphereTriangulation::corners_of(int v) const {
  std::vector<int> around;
  int c = corner_[v];
  do {
    around.push_back(c);
    c = next(opposite_[next(c)]);
  } while (c != corner_[v]);
  return around;
}

double SphereTriangulation::shortest_edge(int v) const {
  double shortest = std::numeric_limits<double>::infinity();
  for (const int c : corners_of(v))
    shortest = std::min(shortest, (points_[vertices_[next(c)]] - points_[v]).norm());
  return shortest;
}

void SphereTriangulation::move(int v, const Vec3& to) {
  const std::vector<int> around = corners_of(v);
  const bool stays_valid = std::all_of(around.begin(), around.end(), [&](int c) {
    return faces_outwards(to, points_[vertices_[next(c)]], points_[vertices_[previous(c)]]);
  });
  if (stays_valid) points_[v] = to;
}

bool SphereTriangulation::should_flip(int c) const {
  const Vec3 &a = points_[vertices_[next(c)]], &b = points_[vertices_[previous(c)]];
  const Vec3 &here = points_[vertices_[c]], &there = points_[vertices_[opposite_[c]]];
  constexpr double rounding = 1e-15;
  // On a sphere Delaunay's triangles are the faces of the convex hull: nothing lies beyond them.
  return height(here, a, b, there) > rounding && faces_outwards(here, a, there) &&
         faces_outwards(here, there, b);
}

void SphereTriangulation::pair_up(int c, int d) {
  opposite_[c] = d;
  opposite_[d] = c;
}

void SphereTriangulation::flip(int c) {
  // Triangles (p, a, b) and (q, b, a) become (p, a, q) and (q, b, p).
  const int d = opposite_[c];
  const int c_a = next(c), c_b = previous(c), d_b = next(d), d_a = previous(d);
  const int beyond_a = opposite_[c_a], beyond_b = opposite_[d_b];
  const int p = vertices_[c], q = vertices_[d];
  vertices_[c_b] = q;
  vertices_[d_a] = p;
  pair_up(c_a, d_b);
  pair_up(c, beyond_b);
  pair_up(d, beyond_a);
  for (const int corner : {c, c_a, c_b, d, d_a, d_b}) corner_[vertices_[corner]] = corner;
}

void SphereTriangulation::make_delaunay() {
  std::vector<int> doubtful;
  for (int c = 0; c < static_cast<int>(vertices_.size()); ++c) doubtful.push_back(c);
  while (!doubtful.empty()) {
    const int c = doubtful.back();
    doubtful.pop_back();
    if (!should_flip(c)) continue;
    const int d = opposite_[c];
    flip(c);
    for (const int corner : {c, next(c), previous(c), d, next(d), previous(d)}) doubtful.push_back(corner);
  }
}

}  // namespace flexkey::bench
