#include "flexkey/mesh/select.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "flexkey/mesh/geodesic.h"
#include "flexkey/mesh/spelling.h"

namespace flexkey {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

void sort_unique(std::vector<int>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

[[noreturn]] void unknown_name(Mark where, const char* kind, const std::string& name,
                               const std::string& mesh_name, const std::vector<std::string>& known) {
  throw SelectionError(where, no_such_name(kind, name, mesh_name, known));
}

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& items) {
  std::vector<std::string> names;
  for (const Named& item : items) names.push_back(item.name);
  return names;
}

}  // namespace

Selector::Selector(const Weld& weld, std::string mesh_name)
    : weld_(weld),
      surface_(weld.surface),
      mesh_name_(std::move(mesh_name)),
      neighbours_(mesh_edges(surface_), surface_.vertex_count()),
      bounds_(bounds_of(surface_.positions)),
      rounding_(1e-9 * bounds_.diagonal()) {}

std::vector<int> Selector::select(const Selection& selection) const {
  std::vector<int> vertices =
      std::visit([&](const auto& kind) { return take(kind, selection.where); }, selection.kind);
  if (vertices.empty()) throw SelectionError(selection.where, "the selection takes no vertex");
  return selection.grow > 0 ? grown(std::move(vertices), selection.grow) : vertices;
}

std::vector<int> Selector::take(const SelectVertices& vertices, Mark where) const {
  std::vector<int> taken;
  const int count = static_cast<int>(weld_.to_surface.size());
  for (const IndexRange& range : vertices.ranges) {
    if (range.first < 0 || range.last >= count || range.first > range.last)
      throw SelectionError(where, fmt::format("vertices {}-{} are not all among the {} of {}, 0 to {}",
                                              range.first, range.last, count, mesh_name_, count - 1));
    for (int v = range.first; v <= range.last; ++v) taken.push_back(weld_.to_surface[index(v)]);
  }
  sort_unique(taken);
  return taken;
}

std::vector<int> Selector::vertices_of(const std::vector<int>& faces) const {
  std::vector<int> vertices;
  for (const int f : faces) {
    const std::span<const int> face = surface_.face(f);
    vertices.insert(vertices.end(), face.begin(), face.end());
  }
  sort_unique(vertices);
  return vertices;
}

/// kind: what the user calls a group.
std::vector<int> Selector::of_group(const char* kind, const std::string& name, Mark where) const {
  for (const Group& candidate : surface_.groups)
    if (candidate.name == name) return vertices_of(candidate.faces);
  unknown_name(where, kind, name, mesh_name_, names_of(surface_.groups));
}

std::vector<int> Selector::take(const SelectGroup& group, Mark where) const {
  return of_group("group", group.name, where);
}

std::vector<int> Selector::take(const SelectNode& node, Mark where) const {
  return of_group("node", node.name, where);
}

std::vector<int> Selector::take(const SelectMaterial& material, Mark where) const {
  std::vector<int> faces;
  const std::vector<std::string> names = names_of(surface_.materials);
  const auto found = std::find(names.begin(), names.end(), material.name);
  if (found == names.end()) unknown_name(where, "material", material.name, mesh_name_, names);
  for (int f = 0; f < surface_.face_count(); ++f)
    if (surface_.face_material[index(f)] == found - names.begin()) faces.push_back(f);
  if (faces.empty())
    throw SelectionError(where,
                         fmt::format("no face of {} uses the material '{}'", mesh_name_, material.name));
  return vertices_of(faces);
}

/// The vertices whose distance outside is at most the rounding; where there is none, an error with the least.
std::vector<int> Selector::within(const Eigen::VectorXd& outside_by, Mark where) const {
  std::vector<int> taken;
  for (int v = 0; v < surface_.vertex_count(); ++v)
    if (outside_by[v] <= rounding_) taken.push_back(v);
  if (!taken.empty()) return taken;
  Eigen::Index nearest = 0;
  const double miss = outside_by.minCoeff(&nearest);
  const auto at = surface_.positions.row(nearest);
  const auto file_vertex =
      std::find(weld_.to_surface.begin(), weld_.to_surface.end(), static_cast<int>(nearest));
  throw SelectionError(where, fmt::format("the selection takes no vertex; the nearest, vertex {} at [{:.4g}, "
                                          "{:.4g}, {:.4g}], misses it by {:.4g}",
                                          file_vertex - weld_.to_surface.begin(), at[0], at[1], at[2], miss));
}

std::vector<int> Selector::take(const SelectSphere& sphere, Mark where) const {
  const double radius = sphere.radius.resolve(bounds_.diagonal());
  const Positions offsets = surface_.positions.rowwise() - sphere.center.transpose();
  return within(offsets.rowwise().norm().array() - radius, where);
}

std::vector<int> Selector::take(const SelectBox& box, Mark where) const {
  const Positions under = (-surface_.positions).rowwise() + box.min.transpose();
  const Positions over = surface_.positions.rowwise() - box.max.transpose();
  return within(under.cwiseMax(over).rowwise().maxCoeff(), where);
}

std::vector<int> Selector::take(const SelectPlane& plane, Mark where) const {
  const double reach = plane.within.resolve(bounds_.diagonal());
  const Positions offsets = surface_.positions.rowwise() - plane.point.transpose();
  return within((offsets * plane.normal.normalized()).array().abs() - reach, where);
}

std::vector<int> Selector::take(const SelectAxis& axis, Mark where) const {
  const double low = bounds_.min[axis.axis], extent = bounds_.max[axis.axis] - low;
  const auto threshold = [&](const Length& length) {
    return length.is_share ? low + length.resolve(extent) : length.value;
  };
  const Eigen::VectorXd along = surface_.positions.col(axis.axis);
  Eigen::VectorXd outside_by =
      Eigen::VectorXd::Constant(along.size(), -std::numeric_limits<double>::infinity());
  if (axis.above) outside_by = outside_by.cwiseMax((threshold(*axis.above) - along.array()).matrix());
  if (axis.below) outside_by = outside_by.cwiseMax((along.array() - threshold(*axis.below)).matrix());
  return within(outside_by, where);
}

std::vector<int> Selector::take(const SelectNearest& nearest, Mark) const {
  return {nearest_vertex(surface_.positions, nearest.point)};
}

std::vector<int> Selector::take(const SelectGeodesic& geodesic, Mark) const {
  const double radius = geodesic.radius.resolve(bounds_.diagonal());
  const int source = nearest_vertex(surface_.positions, geodesic.from);
  const std::vector<double> distance = geodesic_distances(surface_, {source}, radius);
  std::vector<int> taken;
  for (int v = 0; v < surface_.vertex_count(); ++v)
    if (distance[index(v)] <= radius + rounding_) taken.push_back(v);
  return taken;
}

std::vector<int> Selector::take(const SelectPath& path, Mark where) const {
  std::vector<int> chain;
  std::vector<bool> taken(index(surface_.vertex_count()), false);
  int last = -1;
  for (const Vec3& point : path.points) {
    const int next = nearest_vertex(surface_.positions, point);
    const std::vector<int> piece = shortest_path(surface_, neighbours_, last < 0 ? next : last, next);
    if (piece.empty())
      throw SelectionError(where,
                           "no chain of edges joins the path's points: they are on different components");
    for (const int v : piece) {
      if (!taken[index(v)]) chain.push_back(v);
      taken[index(v)] = true;
    }
    last = next;
  }
  return chain;
}

std::vector<int> Selector::take(const SelectBoundary& boundary, Mark where) const {
  std::vector<std::vector<int>> loops = boundary_loops(surface_);
  if (loops.empty()) throw SelectionError(where, fmt::format("{} is closed: it has no boundary", mesh_name_));
  if (!boundary.all) loops.resize(1);
  std::vector<int> taken;
  for (const std::vector<int>& loop : loops) taken.insert(taken.end(), loop.begin(), loop.end());
  sort_unique(taken);
  return taken;
}

std::vector<int> Selector::take(const SelectAttribute& attribute, Mark where) const {
  const std::vector<std::string> names = names_of(surface_.attributes);
  const auto found = std::find(names.begin(), names.end(), attribute.name);
  if (found == names.end()) unknown_name(where, "attribute", attribute.name, mesh_name_, names);
  const Eigen::VectorXd& values = surface_.attributes[index(static_cast<int>(found - names.begin()))].values;
  const double low = values.minCoeff<Eigen::PropagateNumbers>(),
               high = values.maxCoeff<Eigen::PropagateNumbers>();
  const auto threshold = [&](const Length& length) {
    return length.is_share ? low + length.resolve(high - low) : length.value;
  };
  const double rounding = 1e-6 * (high - low);  // of the file's floats
  std::vector<int> taken;
  for (int v = 0; v < surface_.vertex_count(); ++v) {
    const bool is_in = !std::isnan(values[v]) &&
                       (!attribute.above || values[v] >= threshold(*attribute.above) - rounding) &&
                       (!attribute.below || values[v] <= threshold(*attribute.below) + rounding);
    if (is_in) taken.push_back(v);
  }
  if (taken.empty())
    throw SelectionError(where,
                         fmt::format("the selection takes no vertex; the values of '{}' go from {:.4g} "
                                     "to {:.4g}",
                                     attribute.name, low, high));
  return taken;
}

std::vector<int> Selector::take(const SelectComponent& component, Mark where) const {
  const Components components = find_components(surface_);
  std::vector<int> taken;
  for (int v = 0; v < surface_.vertex_count(); ++v)
    if (components.of_vertex[index(v)] == component.index) taken.push_back(v);
  if (taken.empty() || component.index < 0)
    throw SelectionError(where, fmt::format("no component {}: {} has {}, counted from 0", component.index,
                                            mesh_name_, components.count));
  return taken;
}

std::vector<int> Selector::take(const SelectAny& any, Mark) const {
  std::vector<int> taken;
  for (const Selection& part : any.of) {
    const std::vector<int> more = select(part);
    taken.insert(taken.end(), more.begin(), more.end());
  }
  sort_unique(taken);
  return taken;
}

std::vector<int> Selector::take(const SelectAll& all, Mark where) const {
  std::vector<int> count(index(surface_.vertex_count()), 0);
  for (const Selection& part : all.of)
    for (const int v : select(part)) ++count[index(v)];
  std::vector<int> taken;
  for (int v = 0; v < surface_.vertex_count(); ++v)
    if (count[index(v)] == static_cast<int>(all.of.size())) taken.push_back(v);
  if (taken.empty()) throw SelectionError(where, "no vertex is in all parts of the selection");
  return taken;
}

std::vector<int> Selector::take(const SelectNot& none_of, Mark where) const {
  std::vector<bool> excluded(index(surface_.vertex_count()), false);
  for (const Selection& part : none_of.of)
    for (const int v : select(part)) excluded[index(v)] = true;
  std::vector<int> taken;
  for (int v = 0; v < surface_.vertex_count(); ++v)
    if (!excluded[index(v)]) taken.push_back(v);
  if (taken.empty()) throw SelectionError(where, "the selection excludes every vertex");
  return taken;
}

std::vector<int> Selector::grown(std::vector<int> vertices, int rings) const {
  std::vector<bool> taken(index(surface_.vertex_count()), false);
  for (const int v : vertices) taken[index(v)] = true;
  std::size_t ring_start = 0;
  for (int ring = 0; ring < rings && ring_start < vertices.size(); ++ring) {
    const std::size_t ring_end = vertices.size();
    for (std::size_t k = ring_start; k < ring_end; ++k)
      for (const int w : neighbours_.of(vertices[k])) {
        if (taken[index(w)]) continue;
        taken[index(w)] = true;
        vertices.push_back(w);
      }
    ring_start = ring_end;
  }
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

}  // namespace flexkey
