#include "flexkey/gltf/source_addition.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "flexkey/gltf/accessors.h"
#include "flexkey/gltf/primitive_parts.h"
#include "flexkey/gltf/read_accessor.h"
#include "flexkey/gltf/sampler_track.h"
#include "flexkey/mesh/error.h"
#include "flexkey/mesh/spelling.h"

namespace flexkey {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

SamplerTrack sampler_track(const WeightTrack& track) {
  SamplerTrack result;
  result.times.resize(static_cast<Eigen::Index>(track.times.size()), 1);
  for (std::size_t k = 0; k < track.times.size(); ++k)
    result.times(static_cast<Eigen::Index>(k), 0) = static_cast<float>(track.times[k]);
  result.values = track.weights;
  return result;
}

/// Some rows of target t, appended as accessors.
struct TargetAppender {
  tinygltf::Model& model;
  const std::vector<int>& vertices;
  std::size_t t;

  auto part(const auto& rows) const { return rows(vertices, Eigen::all).eval(); }

  int positions(const MorphTargets& targets) const {
    return append_deltas(model, nonzero_rows(part(targets.positions[t])));
  }
  int positions(const QuantizedTargets& targets) const {
    if (const std::size_t count = targets.positions.size(); t >= count)
      return append_attribute(model, part(targets.poses.positions[t - count]));
    return append_normalized(model, part(targets.positions[t]), 32767);
  }
  int normals(const MorphTargets& targets) const {
    return append_deltas(model, nonzero_rows(part(targets.normals[t])));
  }
  int normals(const QuantizedTargets& targets) const {
    if (const std::size_t count = targets.positions.size(); t >= count)
      return append_attribute(model, part(targets.poses.normals[t - count]));
    if (targets.normals.empty()) return append_attribute(model, part(targets.float_normals[t]));
    return append_normalized(model, part(targets.normals[t]), targets.normal_largest);
  }
};

class Adding {
 public:
  Adding(tinygltf::Model& model, const GltfSource& source, const SourceTargets& targets)
      : model_(model),
        source_(source),
        targets_(targets),
        scene_(parse_gltf_scene(source.document.json)),
        reader_(scene_, source.document.bytes) {}
  Addition add();

 private:
  const GltfPrimitive& primitive_of(const SolvedNode& node, std::size_t primitive) const;
  std::set<std::string> attributes_of(const SolvedNode& node, std::size_t primitive) const;
  GltfAttributes zeros_for(const SolvedNode& node, std::size_t primitive);
  PrimitiveAddition add_to(std::size_t node, std::size_t primitive);
  void part(GltfPrimitive primitive, const SplitFaces& faces, PrimitiveAddition& addition);
  void append_targets(const SolvedNode& node, std::size_t primitive, const std::vector<int>& rows,
                      PrimitiveAddition& addition);

  int animation_named(const std::string& name) const;
  const SolvedNode* solved(int node) const;
  SamplerTrack track_of(const GltfSampler& sampler) const;
  void change_channels();
  void change_channel(int animation, const GltfWeightsChannel& channel);
  void add_animation(const WeightTrack& track, int into);
  bool is_led(int node, int animation) const;
  SamplerTrack with_own_weights(const SamplerTrack& track, const SolvedNode& node) const;
  int append_values(const FloatRows& values);

  tinygltf::Model& model_;
  const GltfSource& source_;
  const SourceTargets& targets_;
  GltfScene scene_;
  AccessorReader reader_;
  int merged_ = -1;  // the animation of the file that gets the first track
  Addition result_;
};

Addition Adding::add() {
  if (!targets_.merge_into.empty()) merged_ = animation_named(targets_.merge_into);
  if (std::holds_alternative<QuantizedTargets>(targets_.targets))
    for (auto* list : {&model_.extensionsUsed, &model_.extensionsRequired})
      list->emplace_back("KHR_mesh_quantization");
  result_.names = targets_.names;
  for (std::size_t n = 0; n < source_.nodes.size(); ++n) {
    NodeAddition addition{source_.nodes[n].node, {}};
    for (std::size_t p = 0; p < source_.nodes[n].primitives.size(); ++p)
      addition.primitives.push_back(add_to(n, p));
    result_.nodes.push_back(std::move(addition));
  }
  change_channels();
  for (std::size_t t = 0; t < targets_.tracks.size(); ++t)
    add_animation(targets_.tracks[t], t == 0 ? merged_ : -1);
  return std::move(result_);
}

const GltfPrimitive& Adding::primitive_of(const SolvedNode& node, std::size_t primitive) const {
  return scene_.meshes[index(node.mesh)].primitives[primitive];
}

/// What every target of a primitive carries in the end.
std::set<std::string> Adding::attributes_of(const SolvedNode& node, std::size_t primitive) const {
  std::set<std::string> attributes{"POSITION"};
  if (node.primitives[primitive].has_normals) attributes.insert("NORMAL");
  for (const GltfAttributes& target : primitive_of(node, primitive).targets)
    for (const auto& [semantic, accessor] : target) attributes.insert(semantic);
  if (targets_.normals) return attributes;
  attributes.erase("NORMAL");
  attributes.erase("TANGENT");
  return attributes;
}

/// Zeros for the attributes that some target of a primitive, new or the file's, carries only because another
/// does.
GltfAttributes Adding::zeros_for(const SolvedNode& node, std::size_t primitive) {
  const SolvedPrimitive& solved = node.primitives[primitive];
  GltfAttributes zeros;
  for (const std::string& semantic : attributes_of(node, primitive)) {
    bool is_missing = semantic != "POSITION" && !(semantic == "NORMAL" && solved.has_normals);
    int columns = 3;
    for (const GltfAttributes& own : primitive_of(node, primitive).targets) {
      const auto found = own.find(semantic);
      is_missing = is_missing || found == own.end();
      if (found != own.end()) columns = std::max(scene_.accessors[index(found->second)].columns, 1);
    }
    if (is_missing)
      zeros[semantic] = append_deltas(model_, nonzero_rows(FloatRows::Zero(solved.vertex_count, columns)));
  }
  return zeros;
}

PrimitiveAddition Adding::add_to(std::size_t n, std::size_t p) {
  using Fate = PrimitiveSplit::Fate;
  const SolvedNode& node = source_.nodes[n];
  const PrimitiveSplit& split = targets_.split.nodes[n][p];
  PrimitiveAddition addition;
  addition.drop_normals = !targets_.normals;
  if (split.fate == Fate::stays) {
    addition.still = std::exchange(addition.moving, std::nullopt);
    return addition;
  }
  if (split.fate == Fate::parts) part(primitive_of(node, p), split.faces, addition);
  addition.zeros = zeros_for(node, p);
  append_targets(node, p, moving_rows(node.primitives[p], split), addition);
  return addition;
}

/// Appends what the two sides need of their own.
void Adding::part(GltfPrimitive primitive, const SplitFaces& faces, PrimitiveAddition& addition) {
  if (!targets_.normals)
    for (const char* semantic : {"NORMAL", "TANGENT"}) primitive.attributes.erase(semantic);
  addition.moving = compact_part(model_, primitive, faces.moving, reader_);
  if (!faces.still.triangles.empty()) addition.still = sharing_part(model_, primitive, faces.still);
}

/// rows: the clip's vertices that the targets are of.
void Adding::append_targets(const SolvedNode& node, std::size_t p, const std::vector<int>& rows,
                            PrimitiveAddition& addition) {
  const std::set<std::string> attributes = attributes_of(node, p);
  for (std::size_t t = 0; t < targets_.names.size(); ++t) {
    const TargetAppender appender{model_, rows, t};
    GltfAttributes target;
    for (const std::string& semantic : attributes) {
      target[semantic] = std::visit(
          [&](const auto& targets) {
            if (semantic == "POSITION") return appender.positions(targets);
            return semantic == "NORMAL" && node.primitives[p].has_normals ? appender.normals(targets)
                                                                          : addition.zeros.at(semantic);
          },
          targets_.targets);
    }
    addition.targets.push_back(std::move(target));
  }
}

int Adding::animation_named(const std::string& name) const {
  const std::vector<std::string>& known = source_.animations;
  const auto found = std::find(known.begin(), known.end(), name);
  if (found == known.end()) throw InputError(no_such_name("animation", name, "the file of the mesh", known));
  return static_cast<int>(found - known.begin());
}

/// Null for a node that is not solved.
const SolvedNode* Adding::solved(int node) const {
  const auto found = std::find_if(source_.nodes.begin(), source_.nodes.end(),
                                  [&](const SolvedNode& candidate) { return candidate.node == node; });
  return found == source_.nodes.end() ? nullptr : &*found;
}

/// Weights row after row, as a sampler's output has them.
int Adding::append_values(const FloatRows& values) {
  return append_samples(model_, nonzero_rows(values.reshaped<Eigen::RowMajor>(values.size(), 1)));
}

SamplerTrack Adding::track_of(const GltfSampler& sampler) const {
  SamplerTrack track;
  track.interpolation = sampler.interpolation;
  track.times = reader_.rows(sampler.input, 1).cast<float>();
  const FloatRows values = reader_.rows(sampler.output, 1).cast<float>();
  const Eigen::Index rows = track.times.rows() * (sampler.interpolation == "CUBICSPLINE" ? 3 : 1);
  if (rows == 0 || values.rows() % rows != 0)
    throw InputError(fmt::format("accessor {} has {} weights for {} keys", sampler.output, values.rows(),
                                 track.times.rows()));
  track.values = values.reshaped<Eigen::RowMajor>(rows, values.rows() / rows);
  return track;
}

void Adding::change_channels() {
  for (std::size_t a = 0; a < scene_.animations.size(); ++a)
    for (const GltfWeightsChannel& channel : scene_.animations[a].weights)
      if (solved(channel.node) != nullptr) change_channel(static_cast<int>(a), channel);
}

void Adding::change_channel(int animation, const GltfWeightsChannel& channel) {
  const GltfSampler& sampler = scene_.animations[index(animation)].samplers[index(channel.sampler)];
  const SamplerTrack own = track_of(sampler);
  const std::size_t targets = primitive_of(*solved(channel.node), 0).targets.size();
  if (static_cast<std::size_t>(own.values.cols()) != targets)
    throw InputError(fmt::format("accessor {} has {} weights a key, and its mesh has {} morph targets",
                                 sampler.output, own.values.cols(), targets));
  ChannelChange change{animation, channel.channel, -1, 0, ""};
  if (animation == merged_) {
    const SamplerTrack both = side_by_side(own, sampler_track(targets_.tracks.front()));
    change.input = append_times(model_, both.times);
    change.interpolation = both.interpolation;
    change.output = append_values(both.values);
  } else {
    change.output = append_values(padded(own, static_cast<Eigen::Index>(targets_.names.size())).values);
  }
  result_.changed.push_back(std::move(change));
}

bool Adding::is_led(int node, int animation) const {
  if (animation < 0) return false;
  const auto& channels = scene_.animations[index(animation)].weights;
  return std::any_of(channels.begin(), channels.end(),
                     [&](const GltfWeightsChannel& channel) { return channel.node == node; });
}

void Adding::add_animation(const WeightTrack& weights, int into) {
  const SamplerTrack track = sampler_track(weights);
  AnimationAddition animation{weights.name, into, {}};
  int input = -1;
  for (std::size_t n = 0; n < source_.nodes.size(); ++n) {
    const SolvedNode& node = source_.nodes[n];
    const bool is_changed = is_led(node.node, into);  // its channel is
    if (is_changed || !moves(targets_.split.nodes[n])) continue;
    if (input < 0) input = append_times(model_, track.times);
    const int output = append_values(with_own_weights(track, node).values);
    animation.channels.push_back({node.node, input, output});
  }
  result_.animations.push_back(std::move(animation));
}

/// The weights of the file's own targets, at their defaults, before those of the new ones.
SamplerTrack Adding::with_own_weights(const SamplerTrack& track, const SolvedNode& node) const {
  const std::vector<double>& of_node = scene_.nodes[index(node.node)].weights;
  const std::vector<double>& own = of_node.empty() ? scene_.meshes[index(node.mesh)].weights : of_node;
  const auto own_count = static_cast<Eigen::Index>(primitive_of(node, 0).targets.size());
  SamplerTrack result = track;
  result.values = FloatRows::Zero(track.values.rows(), own_count + track.values.cols());
  for (Eigen::Index k = 0; k < own_count && k < static_cast<Eigen::Index>(own.size()); ++k)
    result.values.col(k).setConstant(static_cast<float>(own[static_cast<std::size_t>(k)]));
  result.values.rightCols(track.values.cols()) = track.values;
  return result;
}

}  // namespace

Addition add_targets(tinygltf::Model& model, const GltfSource& source, const SourceTargets& targets) {
  return Adding(model, source, targets).add();
}

}  // namespace flexkey
