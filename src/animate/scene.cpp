#include "flexkey/animate/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <span>

#include "flexkey/animate/join_components.h"
#include "flexkey/animate/lambda_field.h"
#include "flexkey/animate/unheld.h"
#include "flexkey/mesh/connectivity.h"
#include "flexkey/mesh/geodesic.h"
#include "flexkey/mesh/select.h"
#include "flexkey/timeline/sampling.h"

namespace flexkey {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

constexpr int nobody = -1;

std::string vertices_text(std::size_t count) {
  return fmt::format("{} {}", count, count == 1 ? "vertex" : "vertices");
}

/// How many vertices two lists have in common; `sorted` is in increasing order.
std::size_t shared(const std::vector<int>& sorted, const std::vector<int>& other) {
  return static_cast<std::size_t>(std::count_if(other.begin(), other.end(), [&](int v) {
    return std::binary_search(sorted.begin(), sorted.end(), v);
  }));
}

/// Gives amplitudes that are shares of the diagonal their lengths.
void in_mesh_units(double diagonal, Handle& handle) {
  for (Wave& wave : handle.waves) wave.sway.amplitude = {wave.sway.amplitude.resolve(diagonal)};
  for (Noise& noise : handle.noises) noise.sway.amplitude = {noise.sway.amplitude.resolve(diagonal)};
}

/// Binds one shot, collecting every error on the way.
class Binder {
 public:
  Binder(const Shot& shot, const Mesh& mesh);
  Scene bind();

 private:
  void bind_region(const Selector& selector);
  void bind_handles(const Selector& selector);
  void bind_regions(const Selector& selector);
  void bind_lambda(const Selector& selector);
  void bind_attachments(const Selector& selector);
  void ride(const std::vector<int>& vertices, const std::vector<int>& carriers);
  std::vector<int> patch_around(int vertex, int rings) const;
  void refuse_shared_vertices();
  void refuse_regions_that_touch();
  void refuse_handles_outside();
  void place_loose_components();
  void attach(const std::vector<int>& vertices);
  bool is_always_held(int v) const;
  void fail(Mark where, std::string message) {
    errors_.push_back({Diagnostic::Severity::error, where, std::move(message)});
  }

  const Shot& shot_;
  Scene scene_;
  std::string mesh_name_;
  Neighbours neighbours_;
  std::vector<bool> in_region_;          // #V of the surface
  std::vector<int> leader_;              // #V, the handle that leads a vertex, or nobody
  std::vector<std::vector<int>> rigid_;  // vertices of each region of the shot
  std::vector<Diagnostic> errors_;
};

Binder::Binder(const Shot& shot, const Mesh& mesh)
    : shot_(shot),
      scene_{weld(mesh, shot.mesh.weld.resolve(bounds_of(mesh.positions).diagonal())), {}, {}, {}, {}, 0, 0},
      mesh_name_(std::filesystem::path(shot.mesh.file).filename().string()),
      neighbours_(mesh_edges(scene_.weld.surface), scene_.weld.surface.vertex_count()) {
  in_region_.assign(index(scene_.weld.surface.vertex_count()), true);
  leader_.assign(index(scene_.weld.surface.vertex_count()), nobody);
}

Scene Binder::bind() {
  const Selector selector(scene_.weld, mesh_name_);
  bind_region(selector);
  bind_handles(selector);
  bind_regions(selector);
  bind_lambda(selector);
  refuse_shared_vertices();
  refuse_handles_outside();
  refuse_regions_that_touch();
  if (errors_.empty()) bind_attachments(selector);
  if (errors_.empty()) place_loose_components();
  if (!errors_.empty()) throw TimelineError(shot_.file, std::move(errors_));

  for (std::size_t h = 0; h < scene_.handles.size(); ++h) {
    scene_.constraints.strengths.push_back(scene_.handles[h].handle.weight);
    for (const int v : scene_.handles[h].vertices) {
      scene_.constraints.handles.push_back(v);
      scene_.constraints.owner.push_back(static_cast<int>(h));
    }
  }
  for (int v = 0; v < scene_.weld.surface.vertex_count(); ++v) {
    if (!in_region_[index(v)]) continue;
    scene_.constraints.region.push_back(v);
    if (!is_always_held(v)) ++scene_.free_vertices;
  }
  for (std::vector<int>& region : rigid_) {
    std::erase_if(region, [&](int v) { return !in_region_[index(v)]; });  // what rides, or is in no face
    scene_.constraints.rigid.push_back(std::move(region));
  }
  scene_.region_vertices = static_cast<int>(scene_.constraints.region.size());
  return std::move(scene_);
}

/// Met exactly in every frame, as far as one handle sees to it.
bool Binder::is_always_held(int v) const {
  if (leader_[index(v)] == nobody) return false;
  const Handle& leader = scene_.handles[index(leader_[index(v)])].handle;
  return leader.weight == 1 && leader.active.empty();
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
      in_mesh_units(bounds_of(scene_.weld.surface.positions).diagonal(), bound.handle);
      bound.vertices = selector.select(handle.select);
      bound.rest = scene_.weld.surface.positions(bound.vertices, Eigen::all);
      bound.pivot = handle.pivot.value_or(bound.rest.colwise().mean().transpose());
      scene_.handles.push_back(std::move(bound));
    } catch (const SelectionError& error) {
      fail(error.where(), fmt::format("handle '{}': {}", handle.name, error.what()));
    }
}

void Binder::bind_regions(const Selector& selector) {
  for (const RigidSelection& region : shot_.rigid) try {
      rigid_.push_back(selector.select(region.select));
    } catch (const SelectionError& error) {
      rigid_.emplace_back();
      fail(error.where(), fmt::format("rigid region '{}': {}", region.name, error.what()));
    }
  for (std::vector<int>& vertices : rigid_) std::sort(vertices.begin(), vertices.end());
}

void Binder::bind_lambda(const Selector& selector) {
  try {
    scene_.paints = paint_regions(shot_, scene_.weld.surface, selector);
  } catch (const SelectionError& error) {
    fail(error.where(), fmt::format("a region of 'lambda': {}", error.what()));
  }
}

/// Takes what is attached out of the solve, and lets each of its vertices ride on the nearest that is solved.
void Binder::bind_attachments(const Selector& selector) {
  std::vector<std::vector<int>> riding(shot_.attachments.size());
  std::vector<std::vector<int>> carriers(riding.size());
  for (std::size_t k = 0; k < riding.size(); ++k) try {
      const Attachment& attachment = shot_.attachments[k];
      riding[k] = selector.select(attachment.select);
      if (attachment.to) carriers[k] = selector.select(*attachment.to);
      for (const int v : riding[k]) in_region_[index(v)] = false;
    } catch (const SelectionError& error) {
      fail(error.where(), fmt::format("'attach': {}", error.what()));
    }
  for (std::size_t k = 0; k < riding.size(); ++k) {
    const Mark where = shot_.attachments[k].where;
    for (const int v : riding[k]) {
      const bool is_led = leader_[index(v)] != nobody;
      const std::span<const int> around = neighbours_.of(v);
      if (!is_led && std::none_of(around.begin(), around.end(), [&](int w) { return in_region_[index(w)]; }))
        continue;
      fail(where, is_led
                      ? fmt::format("vertices of handle '{}' cannot be attached; they are led",
                                    scene_.handles[index(leader_[index(v)])].handle.name)
                      : "what is attached has to be a part by itself; this shares edges with what is solved");
      break;
    }
    if (carriers[k].empty() && !shot_.attachments[k].to)
      for (int v = 0; v < scene_.weld.surface.vertex_count(); ++v) carriers[k].push_back(v);
    std::erase_if(carriers[k], [&](int v) { return !in_region_[index(v)]; });
    if (carriers[k].empty() && errors_.empty())
      fail(where, "nothing is solved of what 'attach' names under 'to'");
    if (errors_.empty()) ride(riding[k], carriers[k]);
  }
}

/// Each vertex on the cell of the carrier nearest to it.
void Binder::ride(const std::vector<int>& vertices, const std::vector<int>& carriers) {
  const Positions& positions = scene_.weld.surface.positions;
  const Positions candidates = positions(carriers, Eigen::all);
  std::map<int, std::vector<int>> riders;
  for (const int v : vertices)
    riders[carriers[index(nearest_vertex(candidates, positions.row(v).transpose()))]].push_back(v);
  for (auto& [carrier, riding] : riders)
    scene_.riders.push_back({std::move(riding), patch_around(carrier, 1)});
}

std::vector<int> Binder::patch_around(int vertex, int rings) const {
  std::vector<int> patch{vertex};
  std::set<int> seen{vertex};
  for (std::size_t begin = 0, ring = 0; ring < index(rings); ++ring) {
    const std::size_t end = patch.size();
    for (; begin < end; ++begin)
      for (const int w : neighbours_.of(patch[begin]))
        if (seen.insert(w).second) patch.push_back(w);
  }
  return patch;
}

void Binder::refuse_shared_vertices() {
  std::vector<std::vector<int>> sorted;
  for (std::size_t h = 0; h < scene_.handles.size(); ++h) {
    sorted.push_back(scene_.handles[h].vertices);
    std::sort(sorted.back().begin(), sorted.back().end());
    for (const int v : sorted.back()) {
      if (leader_[index(v)] == nobody) leader_[index(v)] = static_cast<int>(h);
    }
  }
  for (std::size_t b = 0; b < scene_.handles.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) {
      const Handle &first = scene_.handles[a].handle, &second = scene_.handles[b].handle;
      const std::size_t count = active_together(first, second) ? shared(sorted[a], sorted[b]) : 0;
      if (count > 0)
        fail(second.where, fmt::format("handles '{}' and '{}' share {}; a vertex follows one handle only",
                                       first.name, second.name, vertices_text(count)));
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

/// A region moves by itself: no vertex of it may follow a handle or another region, or be held outside.
void Binder::refuse_regions_that_touch() {
  for (std::size_t r = 0; r < rigid_.size(); ++r) {
    const RigidSelection& region = shot_.rigid[r];
    const auto outside =
        std::count_if(rigid_[r].begin(), rigid_[r].end(), [&](int v) { return !in_region_[index(v)]; });
    if (outside > 0)
      fail(region.where, fmt::format("{} of the {} vertices of rigid region '{}' lie outside the roi",
                                     outside, rigid_[r].size(), region.name));
    for (const SceneHandle& bound : scene_.handles) {
      if (const std::size_t count = shared(rigid_[r], bound.vertices); count > 0)
        fail(region.where,
             fmt::format("rigid region '{}' and handle '{}' share {}; a region moves by itself, "
                         "so leave the handle's vertices out of it",
                         region.name, bound.handle.name, vertices_text(count)));
    }
    for (std::size_t other = 0; other < r; ++other) {
      if (const std::size_t count = shared(rigid_[other], rigid_[r]); count > 0)
        fail(region.where,
             fmt::format("rigid regions '{}' and '{}' share {}; one region that holds both moves as one body",
                         shot_.rigid[other].name, region.name, vertices_text(count)));
    }
  }
}

void Binder::place_loose_components() {
  const Components parts = find_components(scene_.weld.surface);
  const Components components = join_components(parts, rigid_);
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
               parts.of_vertex[index(vertices[index(c)].front())], mesh_name_, vertices[index(c)].size()));
  }
  for (Diagnostic& error : find_unheld(shot_, scene_, components, in_region_))
    errors_.push_back(std::move(error));
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
  scene_.riders.push_back({vertices, patch_around(carrier, rings)});
}

}  // namespace

Scene bind_shot(const Shot& shot, const Mesh& mesh) {
  return Binder(shot, mesh).bind();
}

}  // namespace flexkey
