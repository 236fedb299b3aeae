#include "flexkey/gltf/source_glb.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <set>
#include <utility>
#include <variant>

#include "flexkey/gltf/extras.h"
#include "flexkey/gltf/following_normals.h"
#include "flexkey/gltf/graft.h"
#include "flexkey/gltf/moved_vertices.h"
#include "flexkey/gltf/pose_targets.h"
#include "flexkey/gltf/reduction.h"
#include "flexkey/gltf/source_addition.h"
#include "flexkey/gltf/source_playback.h"
#include "flexkey/gltf/split_source.h"
#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

Eigen::Matrix3d linear_of(const SolvedNode& node) {
  return node.world.topLeftCorner<3, 3>();
}

/// Brings deltas from the scene's space to those of the nodes.
void to_node_space(const GltfSource& source, std::vector<FloatRows>& deltas) {
  for (const SolvedNode& node : source.nodes) {
    if (linear_of(node).isIdentity(0)) continue;
    const Eigen::Matrix3f back = linear_of(node).inverse().transpose().cast<float>();
    std::set<int> done;  // primitives may share their vertices
    for (const SolvedPrimitive& primitive : node.primitives) {
      if (!done.insert(primitive.first_vertex).second) continue;
      for (FloatRows& rows : deltas) {
        auto part = rows.middleRows(primitive.first_vertex, primitive.vertex_count);
        part = (part * back).eval();
      }
    }
  }
}

/// The most that a node's space is stretched on its way to the scene.
double largest_stretch(const GltfSource& source) {
  double largest = 0;
  for (const SolvedNode& node : source.nodes)
    largest = std::max(largest, Eigen::JacobiSVD<Eigen::Matrix3d>(linear_of(node)).singularValues()[0]);
  return largest;
}

SourceSplit split_of(const GltfSource& source, const SourceTargets& targets, const GltfOptions& options) {
  if (!options.split) return whole(source);
  const auto moved = std::visit([](const auto& rows) { return moved_vertices(rows); }, targets.targets);
  return split_source(source, moved);
}

/// The most targets that a solved mesh has already.
int own_targets(const GltfSource& source) {
  const GltfScene scene = parse_gltf_scene(source.document.json);
  std::size_t most = 0;
  for (const SolvedNode& node : source.nodes)
    most = std::max(most, scene.meshes[static_cast<std::size_t>(node.mesh)].primitives[0].targets.size());
  return static_cast<int>(most);
}

/// The options with the file's own targets taken off those that are allowed.
GltfOptions beside(int own, GltfOptions options) {
  if (own >= options.max_targets)
    throw InputError(
        fmt::format("the file has {} morph targets already, and at most {} are allowed (max_targets)", own,
                    options.max_targets));
  options.max_targets -= own;
  return options;
}

}  // namespace

Built build_into_source(const Clip& clip, const GltfOptions& options, double strictness, Steps& steps) {
  const GltfSource& source = *options.source;
  const FollowingNormals normals(clip.mesh, source);
  const NormalsAt normals_at = [&](const Positions& positions) { return normals.at(positions); };
  const bool has_normals = options.normals && !source.normals.isZero(0);
  const int own = own_targets(source);
  Reduction reduction =
      reduce(clip, {has_normals ? normals_at : NormalsAt(), strictness}, beside(own, options), steps);
  to_node_space(source, reduction.targets.positions);

  Basis& basis = reduction.basis;
  SourceTargets targets;
  targets.names = basis.names;
  targets.normals = options.normals;
  targets.merge_into = options.merge_into;
  if (options.encoding == Encoding::meshopt) {
    targets.targets = quantize_targets(reduction, reduction.rounding / largest_stretch(source));
  } else {
    targets.targets = std::move(reduction.targets);
  }
  targets.split = split_of(source, targets, options);
  targets.tracks = tracks_of(clip, basis, options);
  tinygltf::Model model;
  model.buffers.emplace_back();
  Addition addition = add_targets(model, source, targets);

  Built built;
  built.targets = own + static_cast<int>(basis.names.size());
  built.keys = static_cast<int>(basis.keys.size());
  for (const SplitNote& note : targets.split.notes) built.vertices += note.vertices;
  if (options.split) built.splits = targets.split.notes;
  built.extensions = model.extensionsRequired;
  const ExtendedSource extended{source, targets.split, addition, model};
  Played played{played_by(extended, "POSITION"), {}, normals_at};
  if (has_normals) played.normals = played_by(extended, "NORMAL");
  built.error = measure_playback(played, clip, basis, steps);
  built.pose_error = measure_poses(played, clip, options.poses, basis);

  model.meshes.emplace_back();  // for what is said of the clip
  describe(model, clip, basis, options, built.error);
  addition.glb = glb_of(std::move(model));
  built.glb = graft(source.document, addition);
  int next = static_cast<int>(source.animations.size());
  for (std::size_t k = 0; k < targets.tracks.size(); ++k) {
    const int into = addition.animations[k].into;
    built.animations.push_back({into < 0 ? next++ : into, targets.tracks[k].from, targets.tracks[k].to});
  }
  return built;
}

}  // namespace flexkey
