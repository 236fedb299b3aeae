#include "quality.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <sstream>
#include <utility>

namespace flexkey::meshes {

namespace {

using HalfEdges = std::map<std::pair<Index, Index>, Index>;

double degrees_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / std::acos(-1.0);
}

void measure_topology(const QuadMesh& mesh, const HalfEdges& half_edges, Quality& q) {
  const Index n = mesh.vertices.size();
  q.closed = half_edges.size() == 4 * mesh.faces.size();
  std::vector<Index> root(n), valence(n, 0);
  std::iota(root.begin(), root.end(), Index{0});
  const auto find = [&](Index v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  Index components = n;
  std::vector<Index> out_edge(n, n);
  for (const auto& [edge, face] : half_edges) {
    q.closed = q.closed && half_edges.count({edge.second, edge.first}) > 0;
    ++valence[edge.first];
    out_edge[edge.first] = edge.second;
    const Index a = find(edge.first), b = find(edge.second);
    if (a != b) {
      root[a] = b;
      --components;
    }
  }
  q.single = components == 1;
  q.euler = n + mesh.faces.size() - half_edges.size() / 2;
  q.fans = q.closed;
  for (Index v = 0; v < n && q.fans; ++v) {
    // Walk round the vertex; a pinched one comes back too early.
    Index at = out_edge[v], steps = 0;
    do {
      const Quad& f = mesh.faces[half_edges.at({v, at})];
      const auto here = static_cast<Index>(std::find(f.begin(), f.end(), v) - f.begin());
      at = f[(here + 3) % 4];
      ++steps;
    } while (at != out_edge[v] && steps <= valence[v]);
    q.fans = steps == valence[v];
  }
}

void measure_faces(const QuadMesh& mesh, Quality& q) {
  q.least_angle = 180.0;
  double shortest = 1e9, edge_sum = 0.0;
  for (const Quad& f : mesh.faces) {
    std::array<Vec3, 4> p;
    for (Index i = 0; i < 4; ++i) p[i] = mesh.vertices[f[i]];
    for (Index i = 0; i < 4; ++i) {
      const Vec3 next = p[(i + 1) % 4] - p[i], last = p[(i + 3) % 4] - p[i];
      const double angle = degrees_between(next, last);
      q.least_angle = std::min(q.least_angle, angle);
      q.largest_angle = std::max(q.largest_angle, angle);
      shortest = std::min(shortest, next.norm());
      edge_sum += next.norm();
    }
    const Vec3 a = (p[1] - p[0]).cross(p[2] - p[0]), b = (p[2] - p[0]).cross(p[3] - p[0]);
    q.worst_warp = std::max(q.worst_warp, degrees_between(a, b));
    q.volume += (p[0].dot(p[1].cross(p[2])) + p[0].dot(p[2].cross(p[3]))) / 6.0;
  }
  q.mean_edge = edge_sum / static_cast<double>(4 * mesh.faces.size());
  q.shortest_edge = shortest / q.mean_edge;
}

}  // namespace

Quality measure(const QuadMesh& mesh) {
  Quality q;
  HalfEdges half_edges;
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (Index i = 0; i < 4; ++i) half_edges[{mesh.faces[f][i], mesh.faces[f][(i + 1) % 4]}] = f;
  measure_topology(mesh, half_edges, q);
  measure_faces(mesh, q);
  for (const auto& [edge, face] : half_edges) {
    const auto twin = half_edges.find({edge.second, edge.first});
    if (twin == half_edges.end()) continue;
    const double bend = degrees_between(face_area_vector(mesh, face), face_area_vector(mesh, twin->second));
    if (bend <= q.worst_bend) continue;
    q.worst_bend = bend;
    q.worst_place = mesh.vertices[edge.first];
  }
  for (Index v = 0; v < mesh.vertex_mirror.size(); ++v) {
    const Vec3& m = mesh.vertices[mesh.vertex_mirror[v]];
    q.asymmetry = std::max(q.asymmetry, (mesh.vertices[v] - Vec3(-m.x(), m.y(), m.z())).norm());
  }
  return q;
}

std::string report(const std::string& name, const QuadMesh& mesh, const Quality& q) {
  Vec3 lo = mesh.vertices[0], hi = lo;
  for (const Vec3& p : mesh.vertices) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  std::ostringstream out;
  out.precision(3);
  out << name << ": " << mesh.vertices.size() << " vertices, " << mesh.faces.size() << " quads\n  closed "
      << q.closed << ", one component " << q.single << ", fans " << q.fans << ", euler " << q.euler
      << ", volume " << q.volume << ", asymmetry " << q.asymmetry << "\n  angles " << q.least_angle << ".."
      << q.largest_angle << ", shortest edge " << q.shortest_edge << " of mean " << q.mean_edge << ", warp "
      << q.worst_warp << ", bend " << q.worst_bend << " at (" << q.worst_place.transpose() << ")\n  box ("
      << lo.transpose() << ") .. (" << hi.transpose() << ")\n  parts";
  for (Index part = 0; part < mesh.part_names.size(); ++part)
    out << ' ' << mesh.part_names[part] << '=' << std::count(mesh.parts.begin(), mesh.parts.end(), part);
  out << '\n';
  return out.str();
}

}  // namespace flexkey::meshes
