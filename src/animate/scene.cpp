#include "flexkey/animate/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>

#include "flexkey/mesh/connectivity.h"
#include "flexkey/mesh/select.h"

namespace flexkey {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

constexpr int nobody = -1;

/// Binds one shot, collecting every error on the way.
class Binder {
 public:
  Binder(const Shot& shot, const Mesh& mesh);
  Scene bind();

 private:
  void bind_region(const Selector& selector);
  void bind_handles(const Selector& selector);
  void refuse_shared_vertices();
  void refuse_handles_outside();
  void place_loose_components();
  void attach(const std::vector<int>& vertices);
  void fail(Mark where, std::string message) {
    errors_.push_back({Diagnostic::Severity::error, where, std::move(message)});
  }

  const Shot& shot_;
  Scene scene_;
  std::string mesh_name_;
  Neighbours neighbours_;
  std::vector<bool> in_region_;  // #V of the surface
  std::vector<int> leader_;      // #V, the handle that leads a vertex, or nobody
  std::vector<Diagnostic> errors_;
};

Binder::Binder(const Shot& shot, const Mesh& mesh)
    : shot_(shot),
      scene_{weld(mesh, shot.mesh.weld.resolve(bounds_of(mesh.positions).diagonal())), {}, {}, {}, 0, 0},
      mesh_name_(std::filesystem::path(shot.mesh.file).filename().string()),
      neighbours_(mesh_edges(scene_.weld.surface), scene_.weld.surface.vertex_count()) {
  in_region_.assign(index(scene_.weld.surface.vertex_count()), true);
  leader_.assign(index(scene_.weld.surface.vertex_count()), nobody);
}

Scene Binder::bind() {
  const Selector selector(scene_.weld, mesh_name_);
  bind_region(selector);
  bind_handles(selector);
  refuse_shared_vertices();
  refuse_handles_outside();
  if (errors_.empty()) place_loose_components();
  if (!errors_.empty()) throw TimelineError(shot_.file, std::move(errors_));

  for (std::size_t h = 0; h < scene_.handles.size(); ++h)
    for (const int v : scene_.handles[h].vertices) {
      scene_.constraints.handles.push_back(v);
      scene_.constraints.owner.push_back(static_cast<int>(h));
    }
  for (int v = 0; v < scene_.weld.surface.vertex_count(); ++v) {
    if (!in_region_[index(v)]) continue;
    scene_.constraints.region.push_back(v);
    if (leader_[index(v)] == nobody) ++scene_.free_vertices;
  }
  scene_.region_vertices = static_cast<int>(scene_.constraints.region.size());
  return std::move(scene_);
}

void Binder::bind_region(const Selector& selector) {
  if (!shot_.roi) return;
  try {
    const std::vector<int> region = selector.select(*shot_.roi);
    std::fill(in_region_.begin(), in_region_.end(), false);
    for (const int v : region) in_region_[index(v)] = true;
  } catch (const SelectionError& error) {
    fail(error.where(), error.what());
  }
}

void Binder::bind_handles(const Selector& selector) {
  for (const Handle& handle : shot_.handles) try {
      SceneHandle bound;
      bound.handle = handle;
      bound.vertices = selector.select(handle.select);
      bound.rest = scene_.weld.surface.positions(bound.vertices, Eigen::all);
      bound.pivot = handle.pivot.value_or(bound.rest.colwise().mean().transpose());
      scene_.handles.push_back(std::move(bound));
    } catch (const SelectionError& error) {
      fail(error.where(), fmt::format("handle '{}': {}", handle.name, error.what()));
    }
}

void Binder::refuse_shared_vertices() {
  std::vector<std::vector<int>> shared(scene_.handles.size(), std::vector<int>(scene_.handles.size(), 0));
  for (std::size_t h = 0; h < scene_.handles.size(); ++h)
    for (const int v : scene_.handles[h].vertices) {
      int& leader = leader_[index(v)];
      if (leader == nobody) {
        leader = static_cast<int>(h);
      } else {
        ++shared[index(leader)][h];
      }
    }
  for (std::size_t a = 0; a < scene_.handles.size(); ++a)
    for (std::size_t b = a + 1; b < scene_.handles.size(); ++b) {
      if (shared[a][b] == 0) continue;
      const Handle& second = scene_.handles[b].handle;
      fail(second.where, fmt::format("handles '{}' and '{}' share {} {}; a vertex follows one handle only",
                                     scene_.handles[a].handle.name, second.name, shared[a][b],
                                     shared[a][b] == 1 ? "vertex" : "vertices"));
    }
}

void Binder::refuse_handles_outside() {
  for (const SceneHandle& bound : scene_.handles) {
    const auto outside = std::count_if(bound.vertices.begin(), bound.vertices.end(),
                                       [&](int v) { return !in_region_[index(v)]; });
    if (outside > 0)
      fail(bound.handle.where, fmt::format("{} of the {} vertices of handle '{}' lie outside the roi",
                                           outside, bound.vertices.size(), bound.handle.name));
  }
}

void Binder::place_loose_components() {
  const Components components = find_components(scene_.weld.surface);
  std::vector<std::vector<int>> vertices(index(components.count));
  std::vector<bool> held(index(components.count), false);
  for (int v = 0; v < scene_.weld.surface.vertex_count(); ++v) {
    const int component = components.of_vertex[index(v)];
    if (component < 0) {
      in_region_[index(v)] = in_region_[index(v)] && leader_[index(v)] != nobody;
      continue;
    }
    vertices[index(component)].push_back(v);
    // A border to what lies outside the region holds a component as an anchor does.
    if (leader_[index(v)] != nobody || !in_region_[index(v)]) held[index(component)] = true;
  }
  for (int c = 0; c < components.count; ++c) {
    if (held[index(c)]) continue;
    for (const int v : vertices[index(c)]) in_region_[index(v)] = false;
    if (shot_.mesh.loose == MeshSource::Loose::error)
      fail(shot_.mesh.where,
           fmt::format(
               "component {} of {} ({} vertices) is touched by no handle or anchor; lead it with a handle, "
               "or write 'loose: attach' or 'loose: hold'",
               c, mesh_name_, vertices[index(c)].size()));
  }
  if (shot_.mesh.loose != MeshSource::Loose::attach) return;
  for (int c = 0; c < components.count; ++c)
    if (!held[index(c)]) attach(vertices[index(c)]);
}

void Binder::attach(const std::vector<int>& vertices) {
  const Positions& positions = scene_.weld.surface.positions;
  const Vec3 centroid = positions(vertices, Eigen::all).colwise().mean().transpose();
  int carrier = nobody;
  double nearest = std::numeric_limits<double>::infinity();
  for (int v = 0; v < scene_.weld.surface.vertex_count(); ++v) {
    if (!in_region_[index(v)]) continue;
    const double distance = (positions.row(v).transpose() - centroid).squaredNorm();
    if (distance >= nearest) continue;
    nearest = distance;
    carrier = v;
  }
  if (carrier == nobody) return;
  constexpr int rings = 2;  // a wider patch turns more steadily than one cell, a much wider one lags behind
  std::vector<int> patch{carrier};
  std::set<int> seen{carrier};
  for (std::size_t begin = 0, ring = 0; ring < rings; ++ring) {
    const std::size_t end = patch.size();
    for (; begin < end; ++begin)
      for (const int w : neighbours_.of(patch[begin]))
        if (seen.insert(w).second) patch.push_back(w);
  }
  scene_.riders.push_back({vertices, std::move(patch)});
}

}  // namespace

Scene bind_shot(const Shot& shot, const Mesh& mesh) {
  return Binder(shot, mesh).bind();
}

}  // namespace flexkey
