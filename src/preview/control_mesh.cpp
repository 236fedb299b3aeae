#include "flexkey/preview/control_mesh.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "flexkey/mesh/connectivity.h"
#include "flexkey/mesh/defects.h"
#include "flexkey/mesh/weld.h"

namespace flexkey {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// Corners of a face of `mesh` that do not repeat the one before, as offsets within the face.
std::vector<int> distinct_corners(std::span<const int> face) {
  std::vector<int> kept;
  for (std::size_t k = 0; k < face.size(); ++k)
    if (face[k] != face[(k + 1) % face.size()]) kept.push_back(static_cast<int>(k));
  return kept;
}

void add_face(ControlMesh& control, const Mesh& welded, int f) {
  const std::span<const int> face = welded.face(f);
  const std::vector<int> kept = distinct_corners(face);
  if (kept.size() < 3) return;
  std::vector<int> vertices;
  for (const int k : kept) {
    vertices.push_back(face[index(k)]);
    control.corner_source.push_back(welded.face_offsets[index(f)] + k);
  }
  control.mesh.add_face(vertices);
  control.face_source.push_back(f);
}

/// Takes over what is sharp where it is still there. number: of each surface vertex, negative without one.
void keep_sharpness(ControlMesh& control, const Mesh& surface, const std::vector<int>& number) {
  std::set<Edge> edges;
  if (!surface.creases.empty())
    for (const MeshEdge& edge : mesh_edges(control.mesh)) edges.insert({edge.low, edge.high});
  for (const Crease& crease : surface.creases) {
    const Edge ends = std::minmax(number[index(crease.from)], number[index(crease.to)]);
    if (edges.count(ends) > 0) control.mesh.creases.push_back({ends.first, ends.second, crease.sharpness});
  }
  for (const SharpVertex& sharp : surface.sharp_vertices)
    if (const int v = number[index(sharp.vertex)]; v >= 0)
      control.mesh.sharp_vertices.push_back({v, sharp.sharpness});
}

/// Numbers the vertices that faces use, in the order of the file, and drops the others.
void drop_unused(ControlMesh& control, const Weld& welded) {
  constexpr int unused = -1, waiting = -2;
  std::vector<int> number(index(welded.surface.vertex_count()), unused);
  for (const int v : control.mesh.corners) number[index(v)] = waiting;
  for (std::size_t v = 0; v < welded.to_surface.size(); ++v) {
    int& on_control = number[index(welded.to_surface[v])];
    if (on_control == waiting) {
      on_control = static_cast<int>(control.vertex_source.size());
      control.vertex_source.push_back(static_cast<int>(v));
    }
    control.of_vertex.push_back(on_control);
  }
  for (int& v : control.mesh.corners) v = number[index(v)];
  keep_sharpness(control, welded.surface, number);
}

/// Vertices whose faces make more than one fan: two cones that touch in a point.
std::vector<int> bowties(const Mesh& mesh) {
  std::vector<std::map<int, int>> around(index(mesh.vertex_count()));  // of a vertex: next -> previous
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k)
      around[index(face[k])].emplace(face[(k + 1) % face.size()], face[(k + face.size() - 1) % face.size()]);
  }
  std::vector<int> found;
  for (std::size_t v = 0; v < around.size(); ++v) {
    std::map<int, int>& fan = around[v];
    int start = fan.begin()->first;
    for (const auto& [next, previous] : fan) {
      const bool is_border =
          std::none_of(fan.begin(), fan.end(), [&](const auto& other) { return other.second == next; });
      if (is_border) start = next;
    }
    for (auto step = fan.find(start); step != fan.end();) {
      const int previous = step->second;
      fan.erase(step);
      step = fan.find(previous);
    }
    if (!fan.empty()) found.push_back(static_cast<int>(v));
  }
  return found;
}

/// Faces that pass a vertex twice.
std::vector<int> self_touching(const Mesh& mesh) {
  std::vector<int> found;
  for (int f = 0; f < mesh.face_count(); ++f) {
    std::vector<int> sorted(mesh.face(f).begin(), mesh.face(f).end());
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) found.push_back(f);
  }
  return found;
}

void to_source(std::vector<int>& indices, const std::vector<int>& source) {
  for (int& i : indices) i = source[index(i)];
}

void to_source(std::vector<Edge>& edges, const std::vector<int>& source) {
  for (auto& [low, high] : edges) {
    low = source[index(low)];
    high = source[index(high)];
  }
}

std::string describe_bowties(const std::vector<int>& vertices) {
  const std::size_t shown = std::min<std::size_t>(vertices.size(), 5);
  return fmt::format("{} {} where surfaces touch in a point ({}{})", vertices.size(),
                     vertices.size() == 1 ? "vertex" : "vertices",
                     fmt::join(std::span(vertices).first(shown), ", "), shown < vertices.size() ? ", …" : "");
}

}  // namespace

ControlMesh control_mesh(const Mesh& mesh, double weld_distance) {
  const Weld welded = weld(mesh, weld_distance);
  ControlMesh control;
  for (int f = 0; f < welded.surface.face_count(); ++f) add_face(control, welded.surface, f);
  drop_unused(control, welded);
  control.mesh.positions = mesh.positions(control.vertex_source, Eigen::all);
  return control;
}

std::string subdivision_obstacle(const ControlMesh& control) {
  Defects defects = find_defects(control.mesh);
  defects.degenerate_faces = self_touching(control.mesh);  // no area is no obstacle
  to_source(defects.degenerate_faces, control.face_source);
  to_source(defects.duplicate_faces, control.face_source);
  to_source(defects.non_manifold_edges, control.vertex_source);
  to_source(defects.flipped_edges, control.vertex_source);
  std::vector<std::string> lines = describe(defects);
  if (lines.empty()) {
    std::vector<int> touching = bowties(control.mesh);  // fans are only defined along manifold edges
    to_source(touching, control.vertex_source);
    if (!touching.empty()) lines.push_back(describe_bowties(touching));
  }
  return fmt::format("{}", fmt::join(lines, ", "));
}

}  // namespace flexkey
