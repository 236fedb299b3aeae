#include "flexkey/deform/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "flexkey/deform/soft.h"
#include "flexkey/deform/vertex_areas.h"

namespace flexkey {
namespace {

constexpr int most_iterations = 1'000'000;
constexpr double no_area = 1e-12;  // share of a component's squared extent

/// Finds the vertices that edges and rigid regions join.
class Search {
 public:
  Search(const Cells& cells, const std::vector<std::vector<int>>& rigid)
      : cells_(cells), rigid_(rigid), body_(cells.count(), -1), seen_(cells.count(), false) {
    for (std::size_t r = 0; r < rigid.size(); ++r) {
      for (const int v : rigid[r]) body_[v] = static_cast<int>(r);
    }
  }

  bool has_seen(int v) const { return seen_[v]; }
  std::vector<int> component_at(int seed) {
    std::vector<int> component;
    add(seed, component);
    for (std::size_t at = 0; at < component.size(); ++at) {
      const int v = component[at];
      for (const auto [j, weight] : cells_.of(v)) add(j, component);
      if (body_[v] >= 0) add_region(body_[v], component);
    }
    return component;
  }

 private:
  void add(int v, std::vector<int>& component) {
    if (!seen_[v]) component.push_back(v);
    seen_[v] = true;
  }
  void add_region(int region, std::vector<int>& component) {
    for (const int v : rigid_[region]) {
      body_[v] = -1;  // once is enough
      add(v, component);
    }
  }

  const Cells& cells_;
  const std::vector<std::vector<int>>& rigid_;
  std::vector<int> body_;  // the region of each vertex that is still to be added, or -1
  std::vector<bool> seen_;
};

std::string name_of(const std::vector<int>& component) {
  const auto first = *std::min_element(component.begin(), component.end());
  return fmt::format("the component of {} vertices at vertex {}", component.size(), first);
}

void require_within(const std::vector<int>& vertices, int vertex_count, const char* role) {
  for (const int v : vertices) {
    if (v < 0 || v >= vertex_count) {
      throw DeformError(
          fmt::format("{} vertex {} is not one of the mesh's {} vertices", role, v, vertex_count));
    }
  }
}

void require_strengths(const Constraints& constraints) {
  const auto count = static_cast<int>(constraints.strengths.size());
  for (std::size_t k = 0; k < constraints.handles.size() && count > 0; ++k) {
    const int handle = owner_of(constraints, k);
    if (handle >= count) throw DeformError(fmt::format("handle {} has no strength", handle));
  }
  for (int handle = 0; handle < count; ++handle) {
    const double strength = constraints.strengths[handle];
    if (strength > 0 && strength <= 1) continue;
    throw DeformError(
        fmt::format("the strength of handle {} is {}; it must be above 0 and at most 1", handle, strength));
  }
}

void require_regions(const std::vector<std::vector<int>>& rigid, const std::vector<bool>& held,
                     const std::vector<bool>& inside) {
  std::vector<int> body(held.size(), -1);
  for (std::size_t r = 0; r < rigid.size(); ++r) {
    require_within(rigid[r], static_cast<int>(held.size()), "rigid region");
    for (const int v : rigid[r]) {
      if (!inside[v]) {
        throw DeformError(
            fmt::format("vertex {} of rigid region {} lies outside the region of interest", v, r));
      }
      if (held[v]) throw DeformError(fmt::format("vertex {} is in rigid region {} and in a handle", v, r));
      if (body[v] == static_cast<int>(r)) {
        throw DeformError(fmt::format("vertex {} is given twice in rigid region {}", v, r));
      }
      if (body[v] >= 0)
        throw DeformError(fmt::format("vertex {} is in rigid regions {} and {}", v, body[v], r));
      body[v] = static_cast<int>(r);
    }
  }
}

}  // namespace

void require_sound(const DeformOptions& options) {
  if (options.iterations < 1 || options.iterations > most_iterations) {
    throw DeformError(
        fmt::format("iterations is {}; it must be from 1 to {}", options.iterations, most_iterations));
  }
  if (!(options.tolerance >= 0))
    throw DeformError(fmt::format("tolerance is {}; it must not be negative", options.tolerance));
  if (!(options.epsilon >= 0) || !std::isfinite(options.epsilon)) {
    throw DeformError(fmt::format("epsilon is {}; it must be a number from 0 upwards", options.epsilon));
  }
  if (options.area_weighting && options.system == System::direct) {
    throw DeformError("area weighting scales the rows of least squares; the direct system has none");
  }
  if (options.cell == Cell::spokes_and_rims && options.weights == Weights::uniform) {
    throw DeformError(
        "spokes and rims are weighted by their triangles' cotangents; uniform weights have none");
  }
}

void require_sound(const Mesh& rest) {
  for (int v = 0; v < rest.vertex_count(); ++v) {
    if (!rest.positions.row(v).allFinite())
      throw DeformError(fmt::format("vertex {} of the mesh is not at a finite position", v));
  }
  for (int f = 0; f < rest.face_count(); ++f) {
    for (const int v : rest.face(f)) {
      if (v >= 0 && v < rest.vertex_count()) continue;
      throw DeformError(
          fmt::format("face {} names vertex {} of a mesh of {} vertices", f, v, rest.vertex_count()));
    }
  }
}

void require_sound(const Constraints& constraints, int vertex_count) {
  require_within(constraints.handles, vertex_count, "handle");
  require_within(constraints.region, vertex_count, "region");
  std::vector<bool> inside(vertex_count, constraints.region.empty());
  for (const int v : constraints.region) inside[v] = true;
  std::vector<bool> held(vertex_count, false);
  for (const int v : constraints.handles) {
    if (held[v]) throw DeformError(fmt::format("handle vertex {} is given twice", v));
    if (!inside[v]) throw DeformError(fmt::format("handle vertex {} lies outside the region of interest", v));
    held[v] = true;
  }
  const std::size_t owners = constraints.owner.size();
  if (owners != 0 && owners != constraints.handles.size()) {
    throw DeformError(
        fmt::format("{} owners were given for {} handle vertices", owners, constraints.handles.size()));
  }
  for (const int handle : constraints.owner) {
    if (handle < 0 || handle >= vertex_count) throw DeformError(fmt::format("there is no handle {}", handle));
  }
  require_strengths(constraints);
  require_regions(constraints.rigid, held, inside);
}

void require_order(const std::vector<int>& order, int vertex_count) {
  if (order.empty() || order.size() == static_cast<std::size_t>(vertex_count)) return;
  throw DeformError(
      fmt::format("an order of {} vertices was given for a mesh of {}", order.size(), vertex_count));
}

void require_held(const Mesh& rest, const Cells& cells, const std::vector<bool>& is_loose,
                  const std::vector<std::vector<int>>& rigid) {
  const Eigen::VectorXd areas = vertex_areas(rest);
  Search search(cells, rigid);
  for (int v = 0; v < cells.count(); ++v) {
    if (!is_loose[v] || search.has_seen(v)) continue;
    const std::vector<int> component = search.component_at(v);
    const bool held = !std::all_of(component.begin(), component.end(), [&](int i) { return is_loose[i]; });
    if (!held) throw DeformError(name_of(component) + " touches no handle or anchor");
    const double extent = bounds_of(rest.positions(component, Eigen::all)).diagonal();
    if (areas(component).sum() <= no_area * extent * extent)
      throw DeformError(name_of(component) + " has no area");
  }
}

void require_targets(const Positions& targets, std::size_t handle_count) {
  if (static_cast<std::size_t>(targets.rows()) != handle_count) {
    throw DeformError(
        fmt::format("{} targets were given for {} handle vertices", targets.rows(), handle_count));
  }
  if (!targets.allFinite()) throw DeformError("a handle's target is not a finite position");
}

void require_turns(const Positions& turns, Eigen::Index handle_count, bool predicts) {
  if (turns.rows() == 0) return;
  if (predicts && turns.rows() != handle_count) {
    throw DeformError(fmt::format("{} turns were given for {} handles", turns.rows(), handle_count));
  }
  if (!turns.allFinite()) throw DeformError("a handle's turn is not finite");
}

void require_lambda(const Eigen::VectorXd& lambda, Eigen::Index vertex_count) {
  if (lambda.size() != vertex_count) {
    throw DeformError(
        fmt::format("{} values of lambda were given for {} vertices", lambda.size(), vertex_count));
  }
  const bool in_range = (lambda.array() >= 0).all() && (lambda.array() <= 1).all();
  if (!in_range) throw DeformError("lambda is not between 0 and 1 everywhere");
}

void require_positions(const Positions& positions, Eigen::Index vertex_count) {
  if (positions.rows() != vertex_count) {
    throw DeformError(fmt::format("{} positions were given for {} vertices", positions.rows(), vertex_count));
  }
  if (!positions.allFinite()) throw DeformError("a position is not finite");
}

void require_pose(const Pose& pose, Eigen::Index vertex_count) {
  const bool same_count = pose.positions.rows() == vertex_count && pose.scales.rows() == vertex_count &&
                          static_cast<Eigen::Index>(pose.rotations.size()) == vertex_count;
  if (!same_count)
    throw DeformError(fmt::format("the pose is not one of this mesh's {} vertices", vertex_count));
}

void require_batch(std::size_t frame_count, std::size_t pose_count) {
  if (frame_count != pose_count)
    throw DeformError(fmt::format("{} frames need as many poses, not {}", frame_count, pose_count));
}

}  // namespace flexkey
