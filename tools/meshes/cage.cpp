#include "cage.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace flexkey::meshes {

namespace {

constexpr double kOnPlane = 1e-9;

// Adds box faces, sharing the vertices that have equal lattice coordinates.
class BoxBuilder {
 public:
  BoxBuilder(QuadMesh& mesh, std::array<std::vector<double>, 3> lines)
      : mesh_(mesh), lines_(std::move(lines)) {}

  // All cells of the side where coordinate `axis` is at its first or last line.
  void add_side(std::size_t axis, bool last) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Index level = last ? lines_[axis].size() - 1 : 0;
    for (Index i = 0; i + 1 < lines_[u].size(); ++i)
      for (Index j = 0; j + 1 < lines_[v].size(); ++j) {
        const auto corner = [&](Index du, Index dv) {
          std::array<Index, 3> at{};
          at[axis] = level;
          at[u] = i + du;
          at[v] = j + dv;
          return vertex(at);
        };
        Quad q{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
        if (!last) std::swap(q[1], q[3]);
        mesh_.faces.push_back(q);
        mesh_.parts.push_back(0);
      }
  }

 private:
  Index vertex(const std::array<Index, 3>& at) {
    const auto [found, is_new] = ids_.try_emplace(at, mesh_.vertices.size());
    if (is_new) mesh_.vertices.emplace_back(lines_[0][at[0]], lines_[1][at[1]], lines_[2][at[2]]);
    return found->second;
  }

  QuadMesh& mesh_;
  std::array<std::vector<double>, 3> lines_;
  std::map<std::array<Index, 3>, Index> ids_;
};

bool on_plane(const Vec3& p) {
  return std::abs(p.x()) < kOnPlane;
}

// Vertices of the patch, each once.
std::set<Index> patch_vertices(const QuadMesh& mesh, const Patch& patch) {
  std::set<Index> used;
  for (Index f : patch) used.insert(mesh.faces[f].begin(), mesh.faces[f].end());
  return used;
}

bool touches_plane(const QuadMesh& mesh, const Patch& patch) {
  for (Index v : patch_vertices(mesh, patch))
    if (on_plane(mesh.vertices[v])) return true;
  return false;
}

// Mean of the patch's vertices; a patch that touches x = 0 is half of one centred on it.
Vec3 patch_centre(const QuadMesh& mesh, const Patch& patch) {
  Vec3 sum = Vec3::Zero();
  const auto used = patch_vertices(mesh, patch);
  for (Index v : used) sum += mesh.vertices[v];
  sum /= static_cast<double>(used.size());
  if (touches_plane(mesh, patch)) sum.x() = 0.0;
  return sum;
}

double patch_radius(const QuadMesh& mesh, const Patch& patch, const Vec3& centre) {
  double sum = 0.0;
  const auto used = patch_vertices(mesh, patch);
  for (Index v : used) sum += (mesh.vertices[v] - centre).norm();
  return sum / static_cast<double>(used.size());
}

Vec3 patch_normal(const QuadMesh& mesh, const Patch& patch, bool centred) {
  Vec3 sum = Vec3::Zero();
  for (Index f : patch) sum += face_area_vector(mesh, f);
  if (centred) sum.x() = 0.0;
  return sum.normalized();
}

}  // namespace

QuadMesh half_box(const std::vector<double>& xs, const std::vector<double>& ys, const std::vector<double>& zs,
                  const std::string& part) {
  QuadMesh mesh;
  mesh.part_names = {part};
  BoxBuilder builder(mesh, {xs, ys, zs});
  builder.add_side(0, true);
  for (std::size_t axis : {1U, 2U})
    for (bool last : {false, true}) builder.add_side(axis, last);
  return mesh;
}

Patch select(const QuadMesh& mesh, const Vec3& lo, const Vec3& hi, const Vec3& facing) {
  Patch found;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const Vec3 c = face_centre(mesh, f);
    const bool inside = (c.array() >= lo.array()).all() && (c.array() <= hi.array()).all();
    if (inside && face_area_vector(mesh, f).normalized().dot(facing.normalized()) > 0.5) found.push_back(f);
  }
  return found;
}

Patch pick(const QuadMesh& mesh, const Vec3& point, const Vec3& facing) {
  Patch nearest;
  double least = 1e9;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (face_area_vector(mesh, f).normalized().dot(facing.normalized()) < 0.3) continue;
    if (touches_plane(mesh, {f}) != on_plane(point)) continue;
    const double distance = (face_centre(mesh, f) - point).norm();
    if (distance >= least) continue;
    least = distance;
    nearest = {f};
  }
  if (nearest.empty()) throw std::runtime_error("the cage has no face for a detail");
  return nearest;
}

void set_part(QuadMesh& mesh, const Patch& patch, const std::string& part) {
  const Index id = part_index(mesh, part);
  for (Index f : patch) mesh.parts[f] = id;
}

void extrude(QuadMesh& mesh, const Patch& patch, const std::string& part,
             const std::function<Vec3(const Vec3&)>& place) {
  std::set<std::pair<Index, Index>> directed;
  for (Index f : patch)
    for (Index i = 0; i < 4; ++i) directed.insert({mesh.faces[f][i], mesh.faces[f][(i + 1) % 4]});

  const auto used = patch_vertices(mesh, patch);
  std::map<Index, Index> doubled;
  std::vector<std::pair<Index, Index>> border;
  for (const auto& [a, b] : directed) {
    if (directed.count({b, a}) > 0) continue;
    if (on_plane(mesh.vertices[a]) && on_plane(mesh.vertices[b])) continue;
    border.emplace_back(a, b);
    for (Index v : {a, b})
      if (doubled.try_emplace(v, mesh.vertices.size()).second) {
        const Vec3 copy = mesh.vertices[v];
        mesh.vertices.push_back(copy);
      }
  }
  for (Index f : patch)
    for (Index& v : mesh.faces[f])
      if (doubled.count(v) > 0) v = doubled.at(v);
  for (Index v : used) {
    Vec3& p = mesh.vertices[doubled.count(v) > 0 ? doubled.at(v) : v];
    const bool keep = on_plane(p);
    p = place(p);
    if (keep) p.x() = 0.0;
  }
  const Index id = part_index(mesh, part);
  for (const auto& [a, b] : border) {
    mesh.faces.push_back({a, b, doubled.at(b), doubled.at(a)});
    mesh.parts.push_back(id);
  }
  set_part(mesh, patch, part);
}

void inset(QuadMesh& mesh, const Patch& patch, const std::string& part, double scale, const Vec3& shift) {
  const Vec3 centre = patch_centre(mesh, patch);
  extrude(mesh, patch, part, [&](const Vec3& p) -> Vec3 { return centre + scale * (p - centre) + shift; });
}

void extrude_tube(QuadMesh& mesh, const Patch& patch, const std::string& part,
                  const std::vector<Section>& path) {
  Vec3 centre = patch_centre(mesh, patch);
  Vec3 along = patch_normal(mesh, patch, centre.x() == 0.0);
  for (Index i = 0; i < path.size(); ++i) {
    const Vec3 before = i > 0 ? path[i - 1].centre : centre;
    const Vec3 after = i + 1 < path.size() ? path[i + 1].centre : path[i].centre;
    const bool given = path[i].facing.norm() > 0.0;
    const Vec3 next = (given ? path[i].facing : Vec3(after - before)).normalized();
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(along, next);
    const double scale = path[i].radius / patch_radius(mesh, patch, centre);
    extrude(mesh, patch, part, [&](const Vec3& p) -> Vec3 {
      const Vec3 flat = (p - centre) - along * along.dot(p - centre);
      return path[i].centre + scale * (turn * flat);
    });
    centre = path[i].centre;
    along = next;
  }
}

void seat(QuadMesh& mesh, const Patch& patch, const std::string& part, const Vec3& foot, const Vec3& facing,
          double radius) {
  constexpr double kMargin = 1.45;  // least width of the patch over that of the loop
  const Vec3 centre = patch_centre(mesh, patch);
  const double scale = std::max(1.0, kMargin * radius / patch_radius(mesh, patch, centre));
  for (Index v : patch_vertices(mesh, patch)) {
    Vec3& p = mesh.vertices[v];
    const bool keep = on_plane(p);
    p = foot + scale * (p - centre);
    if (keep) p.x() = 0.0;
  }
  extrude_tube(mesh, patch, part, {{foot, radius, facing}});
  if (patch.size() > 1 || touches_plane(mesh, patch)) return;

  // Turning the arms of the quad back by their quarter turns and taking the mean gives a square.
  const Quad& quad = mesh.faces[patch.front()];
  const Vec3 normal = facing.normalized();
  std::array<Vec3, 4> arm;
  for (Index i = 0; i < 4; ++i) arm[i] = mesh.vertices[quad[i]] - foot;
  const Vec3 mean = arm[0] - normal.cross(arm[1]) - arm[2] + normal.cross(arm[3]);
  const Vec3 first = radius * (mean - normal * normal.dot(mean)).normalized();
  const Vec3 second = normal.cross(first);
  mesh.vertices[quad[0]] = foot + first;
  mesh.vertices[quad[1]] = foot + second;
  mesh.vertices[quad[2]] = foot - first;
  mesh.vertices[quad[3]] = foot - second;
}

}  // namespace flexkey::meshes
