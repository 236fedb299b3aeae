#include "cli/preview_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "flexkey/animate/handle_states.h"
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
  double next = std::numeric_limits<double>::infinity();
  const auto look = [&](const auto& track) {
    for (const auto& key : track)
      if (key.time > time + instant) next = std::min(next, key.time);
  };
  look(handle.move);
  look(handle.to);
  look(handle.rotate);
  look(handle.scale);
  look(handle.curve);
  return std::isfinite(next) ? next : time;
}

/// The rows of `targets` that are not where the surface is already.
Positions apart(const Positions& targets, const Positions& placed, double diagonal) {
  constexpr double near = 1e-3;  // a share of the diagonal
  std::vector<int> rows;
  for (Eigen::Index k = 0; k < targets.rows(); ++k)
    if ((targets.row(k) - placed.row(k)).norm() > near * diagonal) rows.push_back(static_cast<int>(k));
  return targets(rows, Eigen::all);
}

}  // namespace

Marks marks_at(const Scene& scene, double time, const Positions& posed) {
  const std::vector<int> file_vertex = file_vertices(scene.weld);
  const double diagonal = bounds_of(scene.weld.surface.positions).diagonal();
  Marks marks;
  marks.targets.resize(0, 3);
  for (std::size_t h = 0; h < scene.handles.size(); ++h) {
    const SceneHandle& bound = scene.handles[h];
    if (!is_active(bound.handle, time)) continue;
    std::vector<int> vertices;
    for (const int v : bound.vertices) vertices.push_back(file_vertex[static_cast<std::size_t>(v)]);
    std::vector<int>& marked = bound.handle.is_anchor() ? marks.anchors : marks.handles;
    marked.insert(marked.end(), vertices.begin(), vertices.end());
    if (bound.handle.is_anchor()) continue;
    const HandleStates ahead = sample_states(scene, next_key(bound.handle, time));
    const Positions targets =
        apart(targets_of(scene, ahead, static_cast<int>(h)), posed(vertices, Eigen::all), diagonal);
    const Eigen::Index rows = marks.targets.rows();
    marks.targets.conservativeResize(rows + targets.rows(), 3);
    marks.targets.bottomRows(targets.rows()) = targets;
  }
  return marks;
}

}  // namespace flexkey::cli
