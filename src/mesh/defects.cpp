#include "flexkey/mesh/defects.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

namespace flexkey {
namespace {

/// Twice the area vector's length against the face's size: 0 for a face that is a line or a point.
bool has_area(const Mesh& mesh, std::span<const int> face) {
  const Vec3 origin = mesh.positions.row(face[0]).transpose();
  double area = 0, longest = 0;
  for (std::size_t k = 1; k + 1 < face.size(); ++k) {
    const Vec3 a = mesh.positions.row(face[k]).transpose() - origin;
    const Vec3 b = mesh.positions.row(face[k + 1]).transpose() - origin;
    area += a.cross(b).norm();
    longest = std::max({longest, a.squaredNorm(), b.squaredNorm()});
  }
  constexpr double flat = 1e-12;  // far under any sliver that was meant, above double's rounding
  return area > flat * longest;
}

template <class Item, class Format>
void add_line(std::vector<std::string>& lines, const std::vector<Item>& items, const char* one,
              const char* many, Format format) {
  if (items.empty()) return;
  constexpr std::size_t shown = 5;
  std::string places;
  for (std::size_t k = 0; k < std::min(shown, items.size()); ++k)
    places += (k > 0 ? ", " : "") + format(items[k]);
  if (items.size() > shown) places += ", …";
  lines.push_back(fmt::format("{} {} ({})", items.size(), items.size() == 1 ? one : many, places));
}

}  // namespace

Defects find_defects(const Mesh& mesh) {
  Defects defects;
  std::set<std::vector<int>> seen;
  std::vector<bool> used(static_cast<std::size_t>(mesh.vertex_count()), false);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    std::vector<int> sorted(face.begin(), face.end());
    std::sort(sorted.begin(), sorted.end());
    const bool repeats = std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
    if (repeats || !has_area(mesh, face)) defects.degenerate_faces.push_back(f);
    if (!seen.insert(std::move(sorted)).second) defects.duplicate_faces.push_back(f);
    for (const int v : face) used[static_cast<std::size_t>(v)] = true;
  }
  for (const MeshEdge& edge : mesh_edges(mesh)) {
    if (edge.faces() > 2) defects.non_manifold_edges.emplace_back(edge.low, edge.high);
    if (edge.faces() == 2 && edge.forward != 1) defects.flipped_edges.emplace_back(edge.low, edge.high);
  }
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if (!used[static_cast<std::size_t>(v)]) defects.unreferenced_vertices.push_back(v);
  return defects;
}

std::vector<std::string> describe(const Defects& defects) {
  const auto number = [](int i) { return fmt::to_string(i); };
  const auto edge = [](const Edge& e) { return fmt::format("{}-{}", e.first, e.second); };
  std::vector<std::string> lines;
  add_line(lines, defects.degenerate_faces, "degenerate face", "degenerate faces", number);
  add_line(lines, defects.duplicate_faces, "duplicate face", "duplicate faces", number);
  add_line(lines, defects.non_manifold_edges, "non-manifold edge", "non-manifold edges", edge);
  add_line(lines, defects.flipped_edges, "flipped edge", "flipped edges", edge);
  add_line(lines, defects.unreferenced_vertices, "unreferenced vertex", "unreferenced vertices", number);
  return lines;
}

}  // namespace flexkey
