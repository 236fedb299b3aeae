#include "subdivide.h"

#include <algorithm>
#include <map>
#include <utility>

namespace flexkey::meshes {

namespace {

using Edge = std::pair<Index, Index>;

Edge edge_key(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

struct EdgePoints {
  std::map<Edge, Index> ids;  // edge -> position among the edge points
  std::vector<Edge> ends;
  std::vector<Vec3> face_sum;  // sum of the centres of the (two) faces beside the edge
};

EdgePoints collect_edges(const QuadMesh& mesh) {
  EdgePoints edges;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const Vec3 centre = face_centre(mesh, f);
    for (Index i = 0; i < 4; ++i) {
      const Edge key = edge_key(mesh.faces[f][i], mesh.faces[f][(i + 1) % 4]);
      const auto [at, is_new] = edges.ids.try_emplace(key, edges.ends.size());
      if (is_new) {
        edges.ends.push_back(key);
        edges.face_sum.push_back(Vec3::Zero());
      }
      edges.face_sum[at->second] += centre;
    }
  }
  return edges;
}

std::vector<Vec3> moved_vertices(const QuadMesh& mesh, const EdgePoints& edges) {
  const Index n = mesh.vertices.size();
  std::vector<Vec3> face_sum(n, Vec3::Zero()), edge_sum(n, Vec3::Zero());
  std::vector<double> valence(n, 0.0);
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (Index v : mesh.faces[f]) {
      face_sum[v] += face_centre(mesh, f);
      valence[v] += 1.0;
    }
  for (const auto& [a, b] : edges.ends) {
    const Vec3 middle = 0.5 * (mesh.vertices[a] + mesh.vertices[b]);
    edge_sum[a] += middle;
    edge_sum[b] += middle;
  }
  std::vector<Vec3> moved(n);
  for (Index v = 0; v < n; ++v) {
    const double k = valence[v];
    moved[v] = (face_sum[v] / k + 2.0 * edge_sum[v] / k + (k - 3.0) * mesh.vertices[v]) / k;
  }
  return moved;
}

void map_mirrors(const QuadMesh& mesh, const EdgePoints& edges, QuadMesh& fine) {
  const Index n = mesh.vertices.size();
  const auto& map = mesh.vertex_mirror;
  fine.vertex_mirror = map;
  for (const auto& [a, b] : edges.ends)
    fine.vertex_mirror.push_back(n + edges.ids.at(edge_key(map[a], map[b])));
  for (Index f : mesh.face_mirror) fine.vertex_mirror.push_back(n + edges.ends.size() + f);
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (Index i = 0; i < 4; ++i) {
      const Index g = mesh.face_mirror[f];
      const Quad& twin = mesh.faces[g];
      const auto at = std::find(twin.begin(), twin.end(), map[mesh.faces[f][i]]);
      fine.face_mirror.push_back(4 * g + static_cast<Index>(at - twin.begin()));
    }
}

}  // namespace

QuadMesh subdivided(const QuadMesh& mesh) {
  const EdgePoints edges = collect_edges(mesh);
  QuadMesh fine;
  fine.part_names = mesh.part_names;
  fine.vertices = moved_vertices(mesh, edges);
  for (Index e = 0; e < edges.ends.size(); ++e) {
    const auto& [a, b] = edges.ends[e];
    fine.vertices.push_back((mesh.vertices[a] + mesh.vertices[b] + edges.face_sum[e]) / 4.0);
  }
  for (Index f = 0; f < mesh.faces.size(); ++f) fine.vertices.push_back(face_centre(mesh, f));

  const Index first_edge = mesh.vertices.size();
  const Index first_face = first_edge + edges.ends.size();
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (Index i = 0; i < 4; ++i) {
      const Quad& q = mesh.faces[f];
      const Index next = edges.ids.at(edge_key(q[i], q[(i + 1) % 4]));
      const Index last = edges.ids.at(edge_key(q[(i + 3) % 4], q[i]));
      fine.faces.push_back({q[i], first_edge + next, first_face + f, first_edge + last});
      fine.parts.push_back(mesh.parts[f]);
    }
  map_mirrors(mesh, edges, fine);
  return fine;
}

}  // namespace flexkey::meshes
