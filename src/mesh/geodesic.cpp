#include "flexkey/mesh/geodesic.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace flexkey {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

using Entry = std::pair<double, int>;  // distance, vertex
using Front = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

/// A triangle in the plane, its corner a at the origin and b at (base, 0), and the distances that they have.
struct Unfolded {
  double base = 0;
  double at_a = 0, at_b = 0;
  double c_x = 0, c_y = 0;

  bool crosses(double x) const { return x >= 0 && x <= base; }
};

/// Distance at c for a straight front, as several sources send out together.
double from_front(const Unfolded& triangle) {
  const auto& [base, at_a, at_b, c_x, c_y] = triangle;
  const double along = (at_b - at_a) / base, across = std::sqrt(std::max(0.0, 1 - along * along));
  if (across <= 0 || !triangle.crosses(c_x - c_y * along / across)) return infinity;
  return at_a + along * c_x + across * c_y;
}

/// Distance at c from where the one source of both distances lies, below ab.
double from_point(const Unfolded& triangle) {
  const auto& [base, at_a, at_b, c_x, c_y] = triangle;
  const double source_x = (at_a * at_a - at_b * at_b + base * base) / (2 * base);
  const double source_y = -std::sqrt(std::max(0.0, at_a * at_a - source_x * source_x));
  if (c_y - source_y <= 0) return infinity;
  const double crossing = source_x - source_y * (c_x - source_x) / (c_y - source_y);
  return triangle.crosses(crossing) ? std::hypot(c_x - source_x, c_y - source_y) : infinity;
}

using FrontModel = double (*)(const Unfolded& triangle);

/// Distance at c from the distances at a and b of its triangle; the better of the two edges where the way
/// does not cross ab.
double march(const Vec3& a, const Vec3& b, const Vec3& c, double at_a, double at_b, FrontModel front) {
  const double along_edges = std::min(at_a + (c - a).norm(), at_b + (c - b).norm());
  const Vec3 ab = b - a;
  const double base = ab.norm();
  if (base <= 0 || std::abs(at_a - at_b) > base) return along_edges;
  Unfolded triangle{base, at_a, at_b, (c - a).dot(ab) / base};
  triangle.c_y = std::sqrt(std::max(0.0, (c - a).squaredNorm() - triangle.c_x * triangle.c_x));
  return std::min(along_edges, front(triangle));
}

/// The triangles around each vertex, every fan of a polygon's corners, so that a quad has both diagonals.
std::vector<std::vector<Edge>> opposite_edges(const Mesh& mesh) {
  std::vector<std::vector<Edge>> opposite(index(mesh.vertex_count()));
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    const std::size_t n = face.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 1; k + 1 < n; ++k) {
        const int a = face[i], b = face[(i + k) % n], c = face[(i + k + 1) % n];
        opposite[index(a)].emplace_back(b, c);
        if (n == 3) continue;
        opposite[index(b)].emplace_back(c, a);
        opposite[index(c)].emplace_back(a, b);
      }
  }
  return opposite;
}

}  // namespace

int nearest_vertex(const Positions& positions, const Vec3& point) {
  Eigen::Index nearest = 0;
  (positions.rowwise() - point.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  return static_cast<int>(nearest);
}

std::vector<int> shortest_path(const Mesh& mesh, const Neighbours& neighbours, int from, int to) {
  std::vector<double> distance(index(mesh.vertex_count()), infinity);
  std::vector<int> before(index(mesh.vertex_count()), -1);
  Front front;
  distance[index(from)] = 0;
  front.emplace(0.0, from);
  while (!front.empty()) {
    const auto [reached, v] = front.top();
    front.pop();
    if (v == to) break;
    if (reached > distance[index(v)]) continue;
    for (const int w : neighbours.of(v)) {
      const double candidate = reached + (mesh.positions.row(v) - mesh.positions.row(w)).norm();
      if (candidate >= distance[index(w)]) continue;
      distance[index(w)] = candidate;
      before[index(w)] = v;
      front.emplace(candidate, w);
    }
  }
  if (std::isinf(distance[index(to)])) return {};
  std::vector<int> path;
  for (int v = to; v >= 0; v = before[index(v)]) path.push_back(v);
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<double> geodesic_distances(const Mesh& mesh, const std::vector<int>& sources, double limit) {
  const std::vector<std::vector<Edge>> opposite = opposite_edges(mesh);
  std::vector<double> distance(index(mesh.vertex_count()), infinity);
  Front front;
  for (const int source : sources) {
    distance[index(source)] = 0;
    front.emplace(0.0, source);
  }
  // About one source the front is round; that of several is nearly straight, and no one point is behind it.
  const FrontModel model = sources.size() == 1 ? from_point : from_front;
  const auto point = [&](int v) -> Vec3 { return mesh.positions.row(v).transpose(); };
  const auto lower = [&](int v, double candidate) {
    if (candidate >= distance[index(v)]) return;
    distance[index(v)] = candidate;
    front.emplace(candidate, v);
  };
  while (!front.empty()) {
    const auto [reached, v] = front.top();
    front.pop();
    if (reached > distance[index(v)] || reached > limit) continue;
    for (const auto& [a, b] : opposite[index(v)]) {
      lower(a, march(point(v), point(b), point(a), reached, distance[index(b)], model));
      lower(b, march(point(v), point(a), point(b), reached, distance[index(a)], model));
    }
  }
  return distance;
}

}  // namespace flexkey
