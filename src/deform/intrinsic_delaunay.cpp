#include "flexkey/deform/intrinsic_delaunay.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "flexkey/deform/polygon_cut.h"

namespace flexkey {
namespace {

constexpr double least_slack = 1e-6;      // of a triangle's sides, as a share of the mean length
constexpr double delaunay = -1e-9;        // a sum of cotangents down to this counts as not negative
constexpr std::size_t flips_a_side = 50;  // at most; a sound surface needs about one

/// Triangles glued along their sides. Side s = 3 t + k of triangle t goes from tails[s] to the tail of the
/// triangle's next side.
struct Triangulation {
  std::vector<int> tails;
  std::vector<double> lengths;
  std::vector<int> twins;  // the side that each is glued to, or -1

  int side_count() const { return static_cast<int>(tails.size()); }
};

int next(int side) {
  return side % 3 == 2 ? side - 2 : side + 1;
}
int previous(int side) {
  return next(next(side));
}

/// Glues the sides of edges that two triangles share, each the other way.
void glue(Triangulation& t) {
  std::vector<std::array<int, 3>> by_edge;  // the ends, lower first, and the side
  for (int s = 0; s < t.side_count(); ++s) {
    const auto [low, high] = std::minmax(t.tails[s], t.tails[next(s)]);
    by_edge.push_back({low, high, s});
  }
  std::sort(by_edge.begin(), by_edge.end());
  const auto same_edge = [&](std::size_t i, std::size_t j) {
    return by_edge[i][0] == by_edge[j][0] && by_edge[i][1] == by_edge[j][1];
  };
  t.twins.assign(t.tails.size(), -1);
  for (std::size_t first = 0, end = 0; first < by_edge.size(); first = end) {
    while (end < by_edge.size() && same_edge(first, end)) ++end;
    const int a = by_edge[first][2], b = by_edge[end - 1][2];
    if (end - first != 2 || t.tails[a] == t.tails[b]) continue;
    t.twins[a] = b;
    t.twins[b] = a;
  }
}

/// Adds to all lengths what it takes for the flattest triangle to have some slack.
void draw_out_flat_ones(std::vector<double>& lengths) {
  const double mean = std::reduce(lengths.begin(), lengths.end()) / static_cast<double>(lengths.size());
  double more = 0;
  for (std::size_t s = 0; s < lengths.size(); s += 3) {
    const double a = lengths[s], b = lengths[s + 1], c = lengths[s + 2], longest = std::max({a, b, c});
    more = std::max(more, least_slack * mean - (a + b + c - 2 * longest));
  }
  for (double& length : lengths) length += more;
}

Triangulation triangulate(const Mesh& mesh) {
  Triangulation t;
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const auto& [a, b, c] : cut_polygon(mesh.positions, mesh.face(f))) {
      t.tails.insert(t.tails.end(), {a, b, c});
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        t.lengths.push_back((mesh.positions.row(from) - mesh.positions.row(to)).norm());
      }
    }
  }
  draw_out_flat_ones(t.lengths);
  glue(t);
  return t;
}

double double_area_at(const Triangulation& t, int side) {
  return double_area({t.lengths[side], t.lengths[next(side)], t.lengths[previous(side)]});
}

/// The cotangent of the angle opposite to a side.
double cotangent(const Triangulation& t, int side) {
  const double a = t.lengths[side], b = t.lengths[next(side)], c = t.lengths[previous(side)];
  return (b * b + c * c - a * a) / (2 * double_area_at(t, side));
}

bool wants_flip(const Triangulation& t, int side) {
  const int twin = t.twins[side];
  if (twin < 0 || t.tails[previous(side)] == t.tails[previous(twin)]) return false;
  return cotangent(t, side) + cotangent(t, twin) < delaunay;
}

/// Where the tip of a side's triangle lies with the side along x from the origin: its x and its height.
struct Tip {
  double x, height;
};
Tip tip(double side, double from_tail, double from_head) {
  const double x = (side * side + from_tail * from_tail - from_head * from_head) / (2 * side);
  return {x, double_area({side, from_tail, from_head}) / side};
}

/// The distance of the tips of the two triangles at a side, both unfolded into one plane.
double diagonal(const Triangulation& t, int side, int twin) {
  const double length = t.lengths[side];
  const Tip above = tip(length, t.lengths[previous(side)], t.lengths[next(side)]);
  const Tip below = tip(length, t.lengths[next(twin)], t.lengths[previous(twin)]);
  return std::hypot(above.x - below.x, above.height + below.height);
}

/// Gives the place `to` what lies at `from`, another side of the four around a flip.
struct Outer {
  int tail, twin;
  double length;
};
Outer outer(const Triangulation& t, int side) {
  return {t.tails[side], t.twins[side], t.lengths[side]};
}
void put(const Outer& outer, int side, Triangulation& t) {
  t.tails[side] = outer.tail;
  t.lengths[side] = outer.length;
  t.twins[side] = outer.twin;
  if (outer.twin >= 0) t.twins[outer.twin] = side;
}

/// Triangles (a, b, c) and (b, a, d) become (d, c, a) and (c, d, b). The tips c and d differ, so that no two
/// of the four outer sides are glued to each other.
void flip(Triangulation& t, int side) {
  const int twin = t.twins[side];
  const double length = diagonal(t, side, twin);
  const Outer bc = outer(t, next(side)), ca = outer(t, previous(side));
  const Outer ad = outer(t, next(twin)), db = outer(t, previous(twin));
  put(ca, next(side), t);
  put(ad, previous(side), t);
  put(db, next(twin), t);
  put(bc, previous(twin), t);
  t.tails[side] = db.tail;
  t.tails[twin] = ca.tail;
  t.lengths[side] = t.lengths[twin] = length;
}

void flip_to_delaunay(Triangulation& t) {
  std::vector<int> open(t.tails.size());
  std::iota(open.begin(), open.end(), 0);
  std::size_t flips_left = flips_a_side * t.tails.size();
  while (!open.empty() && flips_left > 0) {
    const int side = open.back();
    open.pop_back();
    if (!wants_flip(t, side)) continue;
    flip(t, side);
    --flips_left;
    for (const int near : {side, t.twins[side]}) open.insert(open.end(), {next(near), previous(near)});
  }
}

}  // namespace

double double_area(const std::array<double, 3>& lengths) {
  std::array<double, 3> sorted = lengths;
  std::sort(sorted.begin(), sorted.end());
  const auto [c, b, a] = sorted;
  const double square = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  return square > 0 ? std::sqrt(square) / 2 : 0;
}

std::vector<IntrinsicTriangle> intrinsic_delaunay(const Mesh& mesh) {
  Triangulation t = triangulate(mesh);
  flip_to_delaunay(t);
  std::vector<IntrinsicTriangle> triangles;
  for (int s = 0; s < t.side_count(); s += 3) {
    triangles.push_back(
        {{t.tails[s], t.tails[s + 1], t.tails[s + 2]}, {t.lengths[s + 1], t.lengths[s + 2], t.lengths[s]}});
  }
  return triangles;
}

}  // namespace flexkey
