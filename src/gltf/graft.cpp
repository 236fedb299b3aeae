#include "flexkey/gltf/graft.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "flexkey/gltf/fill_gaps.h"
#include "flexkey/gltf/float_rows.h"
#include "flexkey/gltf/split_note.h"
#include "flexkey/gltf/unique_name.h"

namespace flexkey {
namespace {

using nlohmann::json;

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

json& items_of(json& root, const char* list) {
  if (!root.contains(list)) root[list] = json::array();
  return root[list];
}

/// How many own targets a mesh of the file has.
std::size_t target_count(const json& mesh) {
  const json& primitive = mesh["primitives"][0];
  return primitive.contains("targets") ? primitive["targets"].size() : 0;
}

/// Whether the node's mesh is only there to be measured with the others.
bool leaves_alone(const NodeAddition& node) {
  return std::all_of(node.primitives.begin(), node.primitives.end(),
                     [](const PrimitiveAddition& one) { return !one.moving && !one.drop_normals; });
}

void drop_normals(json& primitive) {
  for (const char* semantic : {"NORMAL", "TANGENT"}) {
    primitive["attributes"].erase(semantic);
    if (primitive.contains("targets"))
      for (json& target : primitive["targets"]) target.erase(semantic);
  }
}

/// Puts the new node into every list of nodes in which the other one is.
void append_beside(json& root, int other, int node) {
  const auto append = [&](json& owner, const char* key) {
    if (!owner.contains(key)) return;
    json& list = owner[key];
    if (std::find(list.begin(), list.end(), other) != list.end()) list.push_back(node);
  };
  for (json& owner : root["nodes"]) append(owner, "children");
  if (root.contains("scenes"))
    for (json& scene : root["scenes"]) append(scene, "nodes");
}

class Grafting {
 public:
  Grafting(const Glb& file, const Addition& addition)
      : addition_(addition), root_(json::parse(file.json)), added_(json::parse(addition.glb.json)) {
    result_.bytes = file.bytes;
  }
  Glb graft();

 private:
  void append_buffers();
  void append_accessors();
  void append_extensions(const char* list);
  json& mesh_of(int node);
  void extend(const NodeAddition& node);
  void extend_weights(int node, json& mesh, std::size_t own);
  json part_of(json primitive, const PrimitivePart& part) const;
  void extend_primitive(json& primitive, const PrimitiveAddition& addition) const;
  void append_still(int node, json mesh);
  json renumbered(const GltfAttributes& attributes) const;
  void name_targets(json& mesh, std::size_t own) const;
  void append_node(const NewNode& node);
  void change(const ChannelChange& change);
  void animate(const AnimationAddition& addition);
  void describe(json& thing);

  const Addition& addition_;
  json root_, added_;
  int first_accessor_ = 0;
  Glb result_;
};

Glb Grafting::graft() {
  append_buffers();
  append_accessors();
  append_extensions("extensionsUsed");
  append_extensions("extensionsRequired");
  for (const NodeAddition& node : addition_.nodes) extend(node);
  for (const NewNode& node : addition_.new_nodes) append_node(node);
  for (const ChannelChange& changed : addition_.changed) change(changed);
  for (const AnimationAddition& animation : addition_.animations) animate(animation);
  result_.json = root_.dump();
  return std::move(result_);
}

/// Buffer 0 of the addition goes behind the file's, others stand for themselves.
void Grafting::append_buffers() {
  json& buffers = items_of(root_, "buffers");
  if (buffers.empty()) buffers.push_back({{"byteLength", 0}});
  std::vector<unsigned char>& bytes = result_.bytes;
  bytes.resize(index(static_cast<int>(aligned(static_cast<std::int64_t>(bytes.size())))));
  const std::size_t start = bytes.size();
  bytes.insert(bytes.end(), addition_.glb.bytes.begin(), addition_.glb.bytes.end());
  buffers[0]["byteLength"] = bytes.size();
  const std::size_t others = buffers.size() - 1;
  json& added_buffers = items_of(added_, "buffers");
  for (std::size_t b = 1; b < added_buffers.size(); ++b) buffers.push_back(added_buffers[b]);

  const auto move = [&](json& range) {
    const std::size_t buffer = range["buffer"];
    if (buffer == 0) range["byteOffset"] = range.value("byteOffset", std::size_t{0}) + start;
    if (buffer > 0) range["buffer"] = buffer + others;
  };
  json& views = items_of(root_, "bufferViews");
  for (json& view : items_of(added_, "bufferViews")) {
    move(view);
    for (json& extension : items_of(view, "extensions"))
      if (extension.contains("buffer")) move(extension);
    if (view["extensions"].empty()) view.erase("extensions");
    views.push_back(view);
  }
}

void Grafting::append_accessors() {
  const std::size_t first_view = root_["bufferViews"].size() - added_["bufferViews"].size();
  const auto move = [&](json& reference) {
    if (reference.contains("bufferView"))
      reference["bufferView"] = reference["bufferView"].get<std::size_t>() + first_view;
  };
  json& accessors = items_of(root_, "accessors");
  first_accessor_ = static_cast<int>(accessors.size());
  for (json& accessor : items_of(added_, "accessors")) {
    move(accessor);
    if (accessor.contains("sparse")) {
      move(accessor["sparse"]["indices"]);
      move(accessor["sparse"]["values"]);
    }
    accessors.push_back(accessor);
  }
}

void Grafting::append_extensions(const char* list) {
  for (const json& name : items_of(added_, list)) {
    json& names = items_of(root_, list);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
}

/// The node's mesh, which no other node may share.
json& Grafting::mesh_of(int node) {
  json& meshes = root_["meshes"];
  json& mesh = root_["nodes"][index(node)]["mesh"];
  int users = 0;
  for (const json& other : root_["nodes"]) users += other.contains("mesh") && other["mesh"] == mesh ? 1 : 0;
  if (users > 1) {
    meshes.push_back(json(meshes[mesh.get<std::size_t>()]));
    mesh = meshes.size() - 1;
  }
  return meshes[mesh.get<std::size_t>()];
}

void Grafting::extend(const NodeAddition& addition) {
  if (leaves_alone(addition)) return;
  json& mesh = mesh_of(addition.node);
  const std::size_t own = target_count(mesh);
  json moving = json::array(), still = mesh;
  still["primitives"] = json::array();
  for (std::size_t p = 0; p < addition.primitives.size(); ++p) {
    const PrimitiveAddition& added = addition.primitives[p];
    json& primitive = mesh["primitives"][p];
    if (added.drop_normals) drop_normals(primitive);
    if (added.still) still["primitives"].push_back(part_of(primitive, *added.still));
    if (!added.moving) continue;
    moving.push_back(part_of(primitive, *added.moving));
    extend_primitive(moving.back(), added);
  }
  if (moving.empty()) return;  // the whole mesh is still, without a node of its own
  mesh["primitives"] = std::move(moving);
  extend_weights(addition.node, mesh, own);
  describe(mesh);
  name_targets(mesh, own);
  if (!still["primitives"].empty()) append_still(addition.node, std::move(still));
}

/// own: the targets that the mesh had already.
void Grafting::extend_weights(int number, json& mesh, std::size_t own) {
  const std::size_t all = own + addition_.names.size();
  const auto extend = [&](json& weights) {
    weights.get_ref<json::array_t&>().resize(own, 0.0);  // a file may have more weights than targets
    weights.get_ref<json::array_t&>().resize(all, 0.0);
  };
  extend(items_of(mesh, "weights"));
  json& node = root_["nodes"][index(number)];
  if (node.contains("weights")) extend(node["weights"]);
}

json Grafting::part_of(json primitive, const PrimitivePart& part) const {
  if (part.indices < 0) return primitive;
  primitive["indices"] = part.indices + first_accessor_;
  primitive.erase("mode");  // a list of triangles is the default
  if (!part.attributes.empty()) primitive["attributes"] = renumbered(part.attributes);
  json groups = json::array();
  for (const GltfGroup& group : part.groups)
    groups.push_back({{"name", group.name}, {"triangles", group.triangles}});
  if (!groups.empty()) primitive["extras"]["groups"] = std::move(groups);
  return primitive;
}

/// Gives the node's still faces a node that goes where it goes.
void Grafting::append_still(int number, json mesh) {
  mesh.erase("weights");
  if (mesh.contains("name")) mesh["name"] = still_name(mesh["name"]);
  root_["meshes"].push_back(std::move(mesh));
  json& nodes = root_["nodes"];
  const json& shown = nodes[index(number)];
  json still = {{"mesh", root_["meshes"].size() - 1}};
  if (shown.contains("name")) still["name"] = still_name(shown["name"]);
  const int place = static_cast<int>(nodes.size());
  if (shown.contains("skin")) {
    still["skin"] = shown["skin"];
    append_beside(root_, number, place);
  } else {
    items_of(nodes[index(number)], "children").push_back(place);
  }
  nodes.push_back(std::move(still));
}

json Grafting::renumbered(const GltfAttributes& attributes) const {
  json result = json::object();
  for (const auto& [semantic, accessor] : attributes) result[semantic] = accessor + first_accessor_;
  return result;
}

void Grafting::extend_primitive(json& primitive, const PrimitiveAddition& addition) const {
  json& targets = items_of(primitive, "targets");
  for (json& target : targets)
    for (const auto& [semantic, accessor] : addition.targets.front())
      if (!target.contains(semantic)) target[semantic] = addition.zeros.at(semantic) + first_accessor_;
  for (const GltfAttributes& target : addition.targets) targets.push_back(renumbered(target));
}

void Grafting::name_targets(json& mesh, std::size_t own) const {
  json& names = mesh["extras"]["targetNames"];
  const auto is_text = [](const json& name) { return name.is_string(); };
  if (!names.is_array() || names.size() != own || !std::all_of(names.begin(), names.end(), is_text)) {
    names = json::array();
    for (std::size_t target = 0; target < own; ++target) names.push_back(fmt::format("target_{}", target));
  }
  std::set<std::string> known = names.get<std::set<std::string>>();
  for (const std::string& name : addition_.names) names.push_back(unique_name(name, known));
}

void Grafting::append_node(const NewNode& node) {
  json& nodes = items_of(root_, "nodes");
  const Vec3& t = node.translation;
  nodes.push_back({{"name", node.name}, {"translation", {t.x(), t.y(), t.z()}}});
  json& scenes = items_of(root_, "scenes");
  if (scenes.empty()) return;  // all nodes are shown
  items_of(scenes[root_.value("scene", std::size_t{0})], "nodes").push_back(nodes.size() - 1);
}

/// The channel gets a sampler of its own, since others may share the one that it had.
void Grafting::change(const ChannelChange& change) {
  json& animation = root_["animations"][index(change.animation)];
  json& channel = animation["channels"][index(change.channel)];
  json& samplers = animation["samplers"];
  json sampler = samplers[channel["sampler"].get<std::size_t>()];
  if (change.input >= 0) sampler["input"] = change.input + first_accessor_;
  if (!change.interpolation.empty()) sampler["interpolation"] = change.interpolation;
  sampler["output"] = change.output + first_accessor_;

  const json number = channel["sampler"];
  int users = 0;
  for (const json& other : animation["channels"]) users += other["sampler"] == number ? 1 : 0;
  if (users == 1) {
    samplers[number.get<std::size_t>()] = sampler;
  } else {
    samplers.push_back(sampler);
    channel["sampler"] = samplers.size() - 1;
  }
}

void Grafting::animate(const AnimationAddition& addition) {
  json& animations = items_of(root_, "animations");
  if (addition.into < 0) animations.push_back({{"name", addition.name}});
  json& animation = addition.into < 0 ? animations.back() : animations[index(addition.into)];
  json& samplers = items_of(animation, "samplers");
  json& channels = items_of(animation, "channels");
  for (const NewChannel& channel : addition.channels) {
    samplers.push_back({{"input", channel.input + first_accessor_},
                        {"output", channel.output + first_accessor_},
                        {"interpolation", "LINEAR"}});
    channels.push_back(
        {{"sampler", samplers.size() - 1}, {"target", {{"node", channel.node}, {"path", channel.path}}}});
  }
  describe(animation);
}

/// Gives it what the addition says of its mesh.
void Grafting::describe(json& thing) {
  if (!thing.contains("extras") || !thing["extras"].is_object()) thing["extras"] = json::object();
  const json& meshes = items_of(added_, "meshes");
  if (meshes.empty() || !meshes[0].contains("extras")) return;
  json said = meshes[0]["extras"];
  said.erase("targetNames");
  thing["extras"].update(said);
}

}  // namespace

Glb graft(const Glb& file, const Addition& addition) {
  Glb grafted = Grafting(file, addition).graft();
  grafted.json = fill_gaps(file.json, grafted.json);
  return grafted;
}

}  // namespace flexkey
