#include "flexkey/gltf/source_targets.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <Eigen/LU>
#include <algorithm>
#include <set>
#include <sstream>

#include "flexkey/gltf/accessors.h"
#include "flexkey/gltf/read_accessor.h"
#include "flexkey/gltf/weight_track.h"
#include "flexkey/mesh/error.h"
#include "flexkey/mesh/spelling.h"

namespace flexkey {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

class Adding {
 public:
  Adding(const GltfSource& source, const SourceTargets& targets, const AnimationPlace& place)
      : source_(source),
        targets_(targets),
        place_(place),
        scene_(parse_gltf_scene(source.document.json)),
        reader_(scene_, source.document.bytes) {}
  Addition add();

 private:
  void append_targets();
  std::set<std::string> attributes_of(const SolvedNode& node, std::size_t primitive) const;
  bool needs_zeros(const SolvedNode& node, std::size_t primitive) const;
  void append_to(PrimitiveAddition& addition, const SolvedNode& node, std::size_t primitive,
                 const FloatRows& positions, const FloatRows& normals);
  int animation_named(const std::string& name) const;
  bool is_led(int node) const;
  void append_animation();
  void change_channels();
  void change_channel(int animation, const GltfWeightsChannel& channel);
  WeightTrack track_of(const GltfSampler& sampler) const;
  WeightTrack new_track(const SolvedNode& node) const;
  int own_count(const SolvedNode& node) const;
  const SolvedNode* solved(int node) const;
  int append_values(const FloatRows& values);
  GltfDocument serialized() const;

  const GltfSource& source_;
  const SourceTargets& targets_;
  const AnimationPlace& place_;
  GltfScene scene_;
  AccessorReader reader_;
  tinygltf::Model model_;
  Addition result_;
};

Addition Adding::add() {
  result_.names = targets_.names;
  result_.animation_name = place_.name;
  result_.animation = place_.merge_into.empty() ? -1 : animation_named(place_.merge_into);
  append_targets();
  change_channels();
  append_animation();
  result_.document = serialized();
  return std::move(result_);
}

const GltfPrimitive& primitive_of(const GltfScene& scene, const SolvedNode& node, std::size_t primitive) {
  return scene.meshes[index(node.mesh)].primitives[primitive];
}

/// What every target of a primitive carries in the end.
std::set<std::string> Adding::attributes_of(const SolvedNode& node, std::size_t primitive) const {
  std::set<std::string> attributes{"POSITION"};
  if (targets_.normals && node.primitives[primitive].has_normals) attributes.insert("NORMAL");
  for (const GltfAttributes& target : primitive_of(scene_, node, primitive).targets)
    for (const auto& [semantic, accessor] : target) attributes.insert(semantic);
  if (targets_.normals) return attributes;
  attributes.erase("NORMAL");
  attributes.erase("TANGENT");
  return attributes;
}

/// Whether some target of a primitive, new or the file's, carries an attribute only because another does.
bool Adding::needs_zeros(const SolvedNode& node, std::size_t primitive) const {
  const std::set<std::string> attributes = attributes_of(node, primitive);
  std::set<std::string> moving{"POSITION"};
  if (node.primitives[primitive].has_normals) moving.insert("NORMAL");
  const std::vector<GltfAttributes>& own = primitive_of(scene_, node, primitive).targets;
  return !std::includes(moving.begin(), moving.end(), attributes.begin(), attributes.end()) ||
         std::any_of(own.begin(), own.end(), [&](const GltfAttributes& target) {
           return std::any_of(attributes.begin(), attributes.end(),
                              [&](const std::string& semantic) { return !target.contains(semantic); });
         });
}

void Adding::append_targets() {
  for (const SolvedNode& node : source_.nodes) {
    NodeAddition addition{node.node, std::vector<PrimitiveAddition>(node.primitives.size())};
    for (std::size_t p = 0; p < node.primitives.size(); ++p) {
      addition.primitives[p].drop_normals = !targets_.normals;
      if (!needs_zeros(node, p)) continue;
      const FloatRows zeros = FloatRows::Zero(node.primitives[p].vertex_count, 3);
      addition.primitives[p].zeros = append_deltas(model_, nonzero_rows(zeros));
    }
    result_.nodes.push_back(std::move(addition));
  }
  for (std::size_t target = 0; target < targets_.names.size(); ++target) {
    const Positions positions = targets_.positions(target);
    const FloatRows normals = targets_.normals ? targets_.normals(target).cast<float>() : FloatRows();
    for (std::size_t n = 0; n < source_.nodes.size(); ++n) {
      const SolvedNode& node = source_.nodes[n];
      const Eigen::Matrix3d to_node = node.world.topLeftCorner<3, 3>().inverse();
      const FloatRows local = (positions * to_node.transpose()).cast<float>();
      for (std::size_t p = 0; p < node.primitives.size(); ++p)
        append_to(result_.nodes[n].primitives[p], node, p, local, normals);
    }
  }
}

void Adding::append_to(PrimitiveAddition& addition, const SolvedNode& node, std::size_t primitive,
                       const FloatRows& positions, const FloatRows& normals) {
  const SolvedPrimitive& solved = node.primitives[primitive];
  const auto append_rows = [&](const FloatRows& rows) {
    return append_deltas(model_, nonzero_rows(rows.middleRows(solved.first_vertex, solved.vertex_count)));
  };
  GltfAttributes target;
  for (const std::string& semantic : attributes_of(node, primitive)) {
    if (semantic == "POSITION") {
      target[semantic] = append_rows(positions);
    } else if (semantic == "NORMAL" && solved.has_normals) {
      target[semantic] = append_rows(normals);
    } else {
      target[semantic] = addition.zeros;
    }
  }
  addition.targets.push_back(std::move(target));
}

int Adding::animation_named(const std::string& name) const {
  std::vector<std::string> known;
  for (std::size_t a = 0; a < scene_.animations.size(); ++a) {
    if (scene_.animations[a].name == name) return static_cast<int>(a);
    known.push_back(scene_.animations[a].name);
  }
  throw InputError(no_such_name("animation", name, "the file of the mesh", known));
}

const SolvedNode* Adding::solved(int node) const {
  const auto found = std::find_if(source_.nodes.begin(), source_.nodes.end(),
                                  [&](const SolvedNode& candidate) { return candidate.node == node; });
  return found == source_.nodes.end() ? nullptr : &*found;
}

int Adding::own_count(const SolvedNode& node) const {
  return static_cast<int>(primitive_of(scene_, node, 0).targets.size());
}

/// Weights row after row, as a sampler's output has them.
int Adding::append_values(const FloatRows& values) {
  return append_samples(model_, nonzero_rows(values.reshaped<Eigen::RowMajor>(values.size(), 1)));
}

WeightTrack Adding::track_of(const GltfSampler& sampler) const {
  WeightTrack track;
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

/// The new targets' weights behind those of the file's own, which stay at their defaults.
WeightTrack Adding::new_track(const SolvedNode& node) const {
  const std::vector<double>& of_node = scene_.nodes[index(node.node)].weights;
  const std::vector<double>& own = of_node.empty() ? scene_.meshes[index(node.mesh)].weights : of_node;
  WeightTrack track;
  track.times = targets_.times;
  track.values = FloatRows::Zero(targets_.weights.rows(), own_count(node) + targets_.weights.cols());
  for (int k = 0; k < own_count(node) && index(k) < own.size(); ++k)
    track.values.col(k).setConstant(static_cast<float>(own[index(k)]));
  track.values.rightCols(targets_.weights.cols()) = targets_.weights;
  return track;
}

void Adding::change_channels() {
  for (std::size_t a = 0; a < scene_.animations.size(); ++a)
    for (const GltfWeightsChannel& channel : scene_.animations[a].weights)
      if (solved(channel.node) != nullptr) change_channel(static_cast<int>(a), channel);
}

void Adding::change_channel(int animation, const GltfWeightsChannel& channel) {
  const WeightTrack own = track_of(scene_.animations[index(animation)].samplers[index(channel.sampler)]);
  ChannelChange change{animation, channel.channel, -1, 0, ""};
  if (animation == result_.animation) {
    const WeightTrack both = side_by_side(own, {"LINEAR", targets_.times, targets_.weights});
    change.input = append_times(model_, both.times);
    change.interpolation = both.interpolation;
    change.output = append_values(both.values);
  } else {
    change.output = append_values(padded(own, targets_.weights.cols()).values);
  }
  result_.changed.push_back(std::move(change));
}

/// Whether the animation that the weights are merged into leads the node's already.
bool Adding::is_led(int node) const {
  if (result_.animation < 0) return false;
  const auto& channels = scene_.animations[index(result_.animation)].weights;
  return std::any_of(channels.begin(), channels.end(),
                     [&](const GltfWeightsChannel& channel) { return channel.node == node; });
}

void Adding::append_animation() {
  int input = -1;
  for (const SolvedNode& node : source_.nodes) {
    if (is_led(node.node)) continue;
    if (input < 0) input = append_times(model_, targets_.times);
    result_.channels.push_back({node.node, input, append_values(new_track(node).values)});
  }
}

GltfDocument Adding::serialized() const {
  tinygltf::Model bare = model_;
  GltfDocument document;
  for (const tinygltf::Buffer& buffer : bare.buffers) {
    const auto* bytes = reinterpret_cast<const std::byte*>(buffer.data.data());
    document.bytes.assign(bytes, bytes + buffer.data.size());
  }
  bare.buffers.clear();  // else their bytes would go into the JSON
  bare.asset.version = "2.0";
  std::ostringstream text;
  tinygltf::TinyGLTF().WriteGltfSceneToStream(&bare, text, false, false);
  document.json = text.str();
  return document;
}

}  // namespace

Addition make_addition(const GltfSource& source, const SourceTargets& targets, const AnimationPlace& place) {
  return Adding(source, targets, place).add();
}

}  // namespace flexkey
