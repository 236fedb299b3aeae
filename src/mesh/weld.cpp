#include "flexkey/mesh/weld.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace flexkey {
namespace {

using Cell = std::array<double, 3>;  // whole numbers of grid steps, or the position itself

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::size_t hash = 0;
    for (const double x : cell) hash = hash * 1000003u ^ std::hash<double>()(x);
    return hash;
  }
};

/// Finds the earlier vertex that a new one joins, by a grid whose step is the weld distance.
class Representatives {
 public:
  explicit Representatives(double distance) : distance_(distance) {}

  /// The first vertex near `position`, which becomes one itself (as `vertex`) where there is none.
  int find_or_add(const Vec3& position, int vertex) {
    const Cell home = cell_of(position);
    const int reach = distance_ > 0 ? 1 : 0;
    int best = -1;
    for (int dx = -reach; dx <= reach; ++dx)
      for (int dy = -reach; dy <= reach; ++dy)
        for (int dz = -reach; dz <= reach; ++dz) {
          const int found = first_near(position, {home[0] + dx, home[1] + dy, home[2] + dz});
          if (found >= 0 && (best < 0 || found < best)) best = found;
        }
    if (best >= 0) return best;
    cells_[home].push_back({vertex, position});
    return vertex;
  }

 private:
  struct Entry {
    int vertex;
    Vec3 position;
  };

  Cell cell_of(const Vec3& p) const {
    // Adding 0 turns -0 into 0, which compares equal but hashes apart.
    if (distance_ <= 0) return {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0};
    return {std::floor(p.x() / distance_) + 0.0, std::floor(p.y() / distance_) + 0.0,
            std::floor(p.z() / distance_) + 0.0};
  }

  int first_near(const Vec3& position, const Cell& cell) const {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) return -1;
    for (const Entry& entry : found->second)
      if ((entry.position - position).norm() <= distance_) return entry.vertex;
    return -1;
  }

  double distance_;
  std::unordered_map<Cell, std::vector<Entry>, CellHash> cells_;
};

/// Of vertices that are one, the value of the first that has any.
Eigen::VectorXd welded(const Eigen::VectorXd& values, const Weld& weld) {
  Eigen::VectorXd result =
      Eigen::VectorXd::Constant(weld.surface.vertex_count(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t v = 0; v < weld.to_surface.size(); ++v)
    if (double& value = result[weld.to_surface[v]]; std::isnan(value))
      value = values[static_cast<Eigen::Index>(v)];
  return result;
}

}  // namespace

Weld weld(const Mesh& mesh, double distance) {
  Weld result;
  result.to_surface.resize(static_cast<std::size_t>(mesh.vertex_count()));
  Representatives representatives(distance);
  std::vector<int> kept;  // file vertex of each surface vertex
  std::vector<int> surface_of(result.to_surface.size(), -1);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const int first = representatives.find_or_add(mesh.positions.row(v).transpose(), v);
    int& surface_vertex = surface_of[static_cast<std::size_t>(first)];
    if (surface_vertex < 0) {
      surface_vertex = static_cast<int>(kept.size());
      kept.push_back(first);
    }
    result.to_surface[static_cast<std::size_t>(v)] = surface_vertex;
  }

  Mesh& surface = result.surface;
  surface.positions = mesh.positions(kept, Eigen::all);
  surface.face_offsets = mesh.face_offsets;
  surface.corners.reserve(mesh.corners.size());
  for (const int v : mesh.corners) surface.corners.push_back(result.to_surface[static_cast<std::size_t>(v)]);
  surface.materials = mesh.materials;
  surface.face_material = mesh.face_material;
  surface.groups = mesh.groups;
  const auto to_surface = [&](int v) { return result.to_surface[static_cast<std::size_t>(v)]; };
  for (const Crease& crease : mesh.creases)
    surface.creases.push_back({to_surface(crease.from), to_surface(crease.to), crease.sharpness});
  for (const SharpVertex& sharp : mesh.sharp_vertices)
    surface.sharp_vertices.push_back({to_surface(sharp.vertex), sharp.sharpness});
  for (const Attribute& attribute : mesh.attributes)
    surface.attributes.push_back({attribute.name, welded(attribute.values, result)});
  return result;
}

Positions scatter(const Weld& weld, const Positions& surface_positions) {
  return surface_positions(weld.to_surface, Eigen::all);
}

}  // namespace flexkey
