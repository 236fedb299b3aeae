#include "flexkey/gltf/source_glb.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "flexkey/gltf/accessors.h"
#include "flexkey/gltf/extras.h"
#include "flexkey/gltf/following_normals.h"
#include "flexkey/gltf/graft.h"
#include "flexkey/gltf/read_accessor.h"
#include "flexkey/gltf/reduction.h"
#include "flexkey/gltf/source_addition.h"
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

/// One primitive's attribute as a client adds it up.
struct Part {
  Eigen::Matrix4d world;  // from the attribute's space to that of what it is compared with
  FloatRows base;
  std::vector<FloatRows> targets;
};

Positions shown_by(const std::vector<Part>& parts, Eigen::Index count, const Eigen::RowVectorXf& weights) {
  Positions shown(count, 3);
  Eigen::Index row = 0;
  for (const Part& part : parts) {
    FloatRows sum = part.base;
    for (std::size_t t = 0; t < part.targets.size(); ++t) {
      const float weight = weights[static_cast<Eigen::Index>(t)];
      if (weight != 0) sum += weight * part.targets[t];
    }
    const Eigen::Matrix3d linear = part.world.topLeftCorner<3, 3>();
    shown.middleRows(row, sum.rows()) =
        (sum.cast<double>() * linear.transpose()).rowwise() + part.world.topRightCorner<3, 1>().transpose();
    row += sum.rows();
  }
  return shown;
}

/// What the file will play, by the addition's accessors.
class Playing {
 public:
  Playing(const tinygltf::Model& model, const GltfSource& source, const Addition& addition)
      : model_(model), source_(source), addition_(addition), scene_(parse_gltf_scene(source.document.json)) {}

  PlayedAttribute positions() const { return attribute("POSITION"); }
  PlayedAttribute normals() const { return attribute("NORMAL"); }

 private:
  PlayedAttribute attribute(const char* semantic) const {
    PlayedAttribute played;
    for_each(semantic, [&](const SolvedNode& node, std::size_t p, const PrimitiveAddition&) {
      const SolvedPrimitive& solved = node.primitives[p];
      played.vertices.resize(played.vertices.size() + static_cast<std::size_t>(solved.vertex_count));
      std::iota(played.vertices.end() - solved.vertex_count, played.vertices.end(), solved.first_vertex);
    });
    const auto count = static_cast<Eigen::Index>(played.vertices.size());
    played.player = [this, semantic, count]() -> Player {
      return [parts = parts_of(semantic), count](const Eigen::RowVectorXf& weights) {
        return shown_by(parts, count, weights);
      };
    };
    return played;
  }

  /// The primitives whose targets move the attribute.
  template <class Visit>
  void for_each(const std::string& semantic, Visit visit) const {
    for (std::size_t n = 0; n < source_.nodes.size(); ++n) {
      const SolvedNode& node = source_.nodes[n];
      for (std::size_t p = 0; p < node.primitives.size(); ++p) {
        const bool moves = semantic == "POSITION" || node.primitives[p].has_normals;
        const PrimitiveAddition& addition = addition_.nodes[n].primitives[p];
        if (moves && addition.targets.front().contains(semantic)) visit(node, p, addition);
      }
    }
  }

  std::vector<Part> parts_of(const std::string& semantic) const {
    const AccessorReader reader(scene_, source_.document.bytes);
    std::vector<Part> parts;
    for_each(semantic, [&](const SolvedNode& node, std::size_t p, const PrimitiveAddition& addition) {
      const auto& primitives = scene_.meshes[static_cast<std::size_t>(node.mesh)].primitives;
      Part part;
      part.world = semantic == "POSITION" ? node.world : Eigen::Matrix4d::Identity();
      part.base = reader.rows(primitives[p].attributes.at(semantic), 3).cast<float>();
      for (const GltfAttributes& target : addition.targets)
        part.targets.push_back(read_rows(model_, target.at(semantic)));
      parts.push_back(std::move(part));
    });
    return parts;
  }

  const tinygltf::Model& model_;
  const GltfSource& source_;
  const Addition& addition_;
  GltfScene scene_;
};

int vertex_count(const GltfSource& source) {
  int count = 0;
  for (const SolvedNode& node : source.nodes)
    for (const SolvedPrimitive& primitive : node.primitives) count += primitive.vertex_count;
  return count;
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
    targets.targets = quantize_into(basis, reduction.targets, reduction.rounding / largest_stretch(source));
  } else {
    targets.targets = std::move(reduction.targets);
  }
  targets.tracks = tracks_of(clip, basis, options);
  tinygltf::Model model;
  model.buffers.emplace_back();
  Addition addition = add_targets(model, source, targets);

  Built built;
  built.targets = own + static_cast<int>(basis.names.size());
  built.keys = static_cast<int>(basis.keys.size());
  built.vertices = vertex_count(source);
  built.extensions = model.extensionsRequired;
  const Playing playing(model, source, addition);
  Played played{playing.positions(), {}, normals_at};
  if (has_normals) played.normals = playing.normals();
  built.error = measure_playback(played, clip, basis, steps);

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
