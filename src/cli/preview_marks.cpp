#include "cli/preview_marks.h"

#include <algorithm>

#include "cli/handle_paths.h"
#include "flexkey/animate/handle_states.h"
#include "flexkey/mesh/connectivity.h"
#include "flexkey/timeline/sampling.h"

namespace flexkey::cli {
namespace {

/// A file vertex for each of the surface.
std::vector<int> file_vertices(const Weld& weld) {
  std::vector<int> of_surface(static_cast<std::size_t>(weld.surface.vertex_count()));
  for (std::size_t v = weld.to_surface.size(); v-- > 0;)
    of_surface[static_cast<std::size_t>(weld.to_surface[v])] = static_cast<int>(v);
  return of_surface;
}

/// The time of the handle's first key after `time`, or `time` where there is none.
double next_key(const Handle& handle, double time) {
  constexpr double instant = 1e-9;
  const std::vector<double> times = key_times(handle);
  const auto next = std::upper_bound(times.begin(), times.end(), time + instant);
  return next == times.end() ? time : *next;
}

/// Whether each vertex of a set has a neighbour outside it.
std::vector<bool> on_border(const Mesh& surface, const std::vector<int>& vertices) {
  std::vector<bool> is_inside(static_cast<std::size_t>(surface.vertex_count())), result = is_inside;
  for (const int v : vertices) is_inside[static_cast<std::size_t>(v)] = true;
  for (const MeshEdge& edge : mesh_edges(surface)) {
    const auto low = static_cast<std::size_t>(edge.low), high = static_cast<std::size_t>(edge.high);
    if (is_inside[low] != is_inside[high]) result[is_inside[low] ? low : high] = true;
  }
  return result;
}

}  // namespace

HandleMarks::HandleMarks(const Scene& scene, PreviewOutput::Handles which)
    : scene_(scene), diagonal_(bounds_of(scene.weld.surface.positions).diagonal()) {
  if (which == PreviewOutput::Handles::none) return;
  const std::vector<int> file_vertex = file_vertices(scene.weld);
  for (const SceneHandle& handle : scene.handles) {
    const std::vector<bool> is_border = on_border(scene.weld.surface, handle.vertices);
    Marked& marked = marked_.emplace_back();
    for (std::size_t row = 0; row < handle.vertices.size(); ++row) {
      const auto vertex = static_cast<std::size_t>(handle.vertices[row]);
      if (which == PreviewOutput::Handles::borders && !is_border[vertex]) continue;
      marked.rows.push_back(static_cast<int>(row));
      marked.file_vertices.push_back(file_vertex[vertex]);
    }
  }
}

/// The targets of a handle's marked vertices that are not where the surface is already.
Positions HandleMarks::targets_ahead(std::size_t handle, double time, const Positions& posed) const {
  constexpr double near = 1e-3;  // a share of the diagonal
  const Marked& marked = marked_[handle];
  const HandleStates ahead = sample_states(scene_, next_key(scene_.handles[handle].handle, time));
  const Positions targets = targets_of(scene_, ahead, static_cast<int>(handle))(marked.rows, Eigen::all);
  std::vector<int> apart;
  for (std::size_t k = 0; k < marked.rows.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    if ((targets.row(row) - posed.row(marked.file_vertices[k])).norm() > near * diagonal_)
      apart.push_back(static_cast<int>(k));
  }
  return targets(apart, Eigen::all);
}

Marks HandleMarks::of_all() const {
  Marks marks;
  marks.targets.resize(0, 3);
  for (std::size_t h = 0; h < marked_.size(); ++h) {
    const std::vector<int>& vertices = marked_[h].file_vertices;
    std::vector<int>& of_kind = scene_.handles[h].handle.is_anchor() ? marks.anchors : marks.handles;
    of_kind.insert(of_kind.end(), vertices.begin(), vertices.end());
  }
  return marks;
}

Marks HandleMarks::at(double time, const Positions& posed) const {
  Marks marks;
  marks.targets.resize(0, 3);
  for (std::size_t h = 0; h < marked_.size(); ++h) {
    const Handle& handle = scene_.handles[h].handle;
    if (!is_active(handle, time)) continue;
    std::vector<int>& vertices = handle.is_anchor() ? marks.anchors : marks.handles;
    vertices.insert(vertices.end(), marked_[h].file_vertices.begin(), marked_[h].file_vertices.end());
    if (handle.is_anchor()) continue;
    const Positions targets = targets_ahead(h, time, posed);
    marks.targets.conservativeResize(marks.targets.rows() + targets.rows(), 3);
    marks.targets.bottomRows(targets.rows()) = targets;
  }
  return marks;
}

}  // namespace flexkey::cli
