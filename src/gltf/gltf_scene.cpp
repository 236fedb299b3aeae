#include "flexkey/gltf/gltf_scene.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <climits>
#include <nlohmann/json.hpp>

#include "flexkey/gltf/json_fields.h"
#include "flexkey/gltf/materials.h"
#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

using nlohmann::json;

/// How many things there are of each kind that others name by index.
struct Sizes {
  std::size_t views, accessors, meshes, nodes, materials, skins;
};

/// Reads every item of a list of the file; what: "accessor", for messages.
template <class Read>
auto read_all(const json& root, const char* key, const char* what, Read read) {
  std::vector<decltype(read(root, std::string()))> all;
  for (const json& item : list_at(root, key, "the file"))
    all.push_back(read(item, fmt::format("{} {}", what, all.size())));
  return all;
}

std::vector<int> indices_at(const json& object, const char* key, std::size_t size, const std::string& what) {
  std::vector<int> indices;
  for (const json& item : list_at(object, key, what)) indices.push_back(index_of(item, key, size, what));
  return indices;
}

GltfView read_view(const json& item, const std::string& what) {
  find_count(item, "target", what);  // for its error
  return {find_count(item, "byteOffset", what).value_or(0), require_count(item, "byteLength", what),
          find_count(item, "byteStride", what).value_or(0)};
}

GltfSparse read_sparse(const json& item, const Sizes& sizes, const std::string& what) {
  const json* indices = find_member(item, "indices", what);
  const json* values = find_member(item, "values", what);
  if (indices == nullptr) refuse_absence("indices", what);
  if (values == nullptr) refuse_absence("values", what);
  GltfSparse sparse;
  sparse.count = require_count(item, "count", what);
  sparse.index_view = require_index(*indices, "bufferView", sizes.views, what);
  sparse.index_offset = find_count(*indices, "byteOffset", what).value_or(0);
  sparse.index_type = require_index(*indices, "componentType", 1u << 16, what);
  sparse.value_view = require_index(*values, "bufferView", sizes.views, what);
  sparse.value_offset = find_count(*values, "byteOffset", what).value_or(0);
  return sparse;
}

int columns_of(const std::string& type, const std::string& what) {
  if (type == "SCALAR") return 1;
  if (type.starts_with("VEC") && type.size() == 4 && type[3] >= '2' && type[3] <= '4') return type[3] - '0';
  if (type == "MAT2" || type == "MAT3" || type == "MAT4") return 0;
  throw InputError(fmt::format("{} is of an unknown type, '{}'", what, type));
}

GltfAccessor read_accessor(const json& item, const Sizes& sizes, const std::string& what) {
  GltfAccessor accessor;
  accessor.view = find_index(item, "bufferView", sizes.views, what);
  accessor.offset = find_count(item, "byteOffset", what).value_or(0);
  accessor.count = require_count(item, "count", what);
  accessor.component_type = require_index(item, "componentType", 1u << 16, what);
  accessor.columns = columns_of(text_at(item, "type", what), what);
  const json* normalized = find_member(item, "normalized", what);
  accessor.normalized = normalized != nullptr && normalized->is_boolean() && normalized->get<bool>();
  if (const json* sparse = find_member(item, "sparse", what))
    accessor.sparse = read_sparse(*sparse, sizes, fmt::format("'sparse' of {}", what));
  return accessor;
}

GltfAttributes read_attributes(const json& item, const Sizes& sizes, const std::string& what) {
  if (!item.is_object()) throw InputError(fmt::format("{} are not a JSON object", what));
  GltfAttributes attributes;
  for (const auto& [semantic, value] : item.items())
    attributes[semantic] = require_index(item, semantic.c_str(), sizes.accessors, what);
  return attributes;
}

/// flexkey's own extras, {groups: [{name, triangles: [first, count, …]}]}; anything else there is another's.
std::vector<GltfGroup> read_groups(const json& item) {
  const auto member = [](const json& object, const char* key) {
    return object.is_object() && object.contains(key) ? object[key] : json();
  };
  std::vector<GltfGroup> groups;
  for (const json& entry : member(member(item, "extras"), "groups")) {
    const json name = member(entry, "name"), runs = member(entry, "triangles");
    const auto is_index = [](const json& value) { return value.is_number_unsigned() && value <= INT_MAX; };
    if (!name.is_string() || !runs.is_array() || runs.size() % 2 != 0) return {};
    if (!std::all_of(runs.begin(), runs.end(), is_index)) return {};
    groups.push_back({name.get<std::string>(), runs.get<std::vector<int>>()});
  }
  return groups;
}

std::vector<std::string> extension_names(const json& item, const std::string& what) {
  std::vector<std::string> names;
  if (const json* extensions = find_member(item, "extensions", what); extensions != nullptr)
    for (const auto& [name, value] : extensions->items()) names.push_back(name);
  return names;
}

GltfPrimitive read_primitive(const json& item, const Sizes& sizes, const std::string& what) {
  GltfPrimitive primitive;
  constexpr std::size_t triangles = 4, last_mode = 6;
  const std::size_t mode = find_count(item, "mode", what).value_or(triangles);
  if (mode > last_mode) refuse_member("mode", what, "is unknown");
  primitive.mode = static_cast<int>(mode);
  primitive.indices = find_index(item, "indices", sizes.accessors, what);
  primitive.material = find_index(item, "material", sizes.materials, what);
  const json* attributes = find_member(item, "attributes", what);
  if (attributes == nullptr) refuse_absence("attributes", what);
  primitive.attributes = read_attributes(*attributes, sizes, fmt::format("'attributes' of {}", what));
  for (const json& target : list_at(item, "targets", what))
    primitive.targets.push_back(read_attributes(target, sizes, fmt::format("'targets' of {}", what)));
  primitive.extensions = extension_names(item, what);
  primitive.groups = read_groups(item);
  return primitive;
}

GltfMesh read_mesh(const json& item, const Sizes& sizes, const std::string& what) {
  GltfMesh mesh;
  mesh.name = text_at(item, "name", what);
  mesh.weights = numbers_at(item, "weights", what);
  for (const json& primitive : list_at(item, "primitives", what))
    mesh.primitives.push_back(
        read_primitive(primitive, sizes, fmt::format("primitive {} of {}", mesh.primitives.size(), what)));
  return mesh;
}

/// `size` numbers, or none where the member is absent.
std::vector<double> vector_at(const json& item, const char* key, std::size_t size, const std::string& what) {
  std::vector<double> numbers = numbers_at(item, key, what);
  if (!numbers.empty() && numbers.size() != size)
    refuse_member(key, what, fmt::format("has {} numbers, not {}", numbers.size(), size));
  return numbers;
}

/// A node's matrix, or translation · rotation · scale.
Eigen::Matrix4d local_matrix(const json& item, const std::string& what) {
  const std::vector<double> matrix = vector_at(item, "matrix", 16, what);
  if (!matrix.empty()) return Eigen::Map<const Eigen::Matrix4d>(matrix.data());
  Eigen::Affine3d local = Eigen::Affine3d::Identity();
  if (const auto t = vector_at(item, "translation", 3, what); !t.empty())
    local.translate(Vec3(t[0], t[1], t[2]));
  if (const auto r = vector_at(item, "rotation", 4, what); !r.empty()) {
    const Eigen::Quaterniond rotation(r[3], r[0], r[1], r[2]);
    if (rotation.norm() == 0) refuse_member("rotation", what, "is no rotation: all four numbers are 0");
    local.rotate(rotation.normalized());
  }
  if (const auto s = vector_at(item, "scale", 3, what); !s.empty()) local.scale(Vec3(s[0], s[1], s[2]));
  return local.matrix();
}

GltfNode read_node(const json& item, const Sizes& sizes, const std::string& what) {
  GltfNode node;
  node.name = text_at(item, "name", what);
  node.mesh = find_index(item, "mesh", sizes.meshes, what);
  node.skin = find_index(item, "skin", sizes.skins, what);
  node.children = indices_at(item, "children", sizes.nodes, what);
  node.local = local_matrix(item, what);
  node.weights = numbers_at(item, "weights", what);
  node.extensions = extension_names(item, what);
  return node;
}

GltfSampler read_sampler(const json& item, const Sizes& sizes, const std::string& what) {
  const std::string interpolation = text_at(item, "interpolation", what);
  return {require_index(item, "input", sizes.accessors, what),
          require_index(item, "output", sizes.accessors, what),
          interpolation.empty() ? "LINEAR" : interpolation};
}

GltfAnimation read_animation(const json& item, const Sizes& sizes, const std::string& what) {
  GltfAnimation animation;
  animation.name = text_at(item, "name", what);
  for (const json& sampler : list_at(item, "samplers", what))
    animation.samplers.push_back(
        read_sampler(sampler, sizes, fmt::format("sampler {} of {}", animation.samplers.size(), what)));
  int number = 0;
  for (const json& channel : list_at(item, "channels", what)) {
    const std::string name = fmt::format("channel {} of {}", number, what);
    const int sampler = require_index(channel, "sampler", animation.samplers.size(), name);
    const json* target = find_member(channel, "target", name);
    const std::string path = target != nullptr ? text_at(*target, "path", name) : std::string();
    const bool is_known = path == "weights" || path == "translation" || path == "rotation" || path == "scale";
    const int node = is_known ? find_index(*target, "node", sizes.nodes, name) : -1;
    if (node >= 0 && path == "weights") animation.weights.push_back({number, sampler, node});
    if (node >= 0 && path != "weights") animation.nodes.push_back({sampler, node, path});
    ++number;
  }
  return animation;
}

/// Name, colour and opacity, for selections and previews; the rest stays in the JSON.
Material read_material(const json& item, const std::string& what) {
  Material material;
  material.name = text_at(item, "name", what);
  material.base_color = Vec3::Ones();
  const json* pbr = find_member(item, "pbrMetallicRoughness", what);
  if (pbr == nullptr) return material;
  const std::vector<double> factor = vector_at(*pbr, "baseColorFactor", 4, what);
  if (factor.empty()) return material;
  for (int i = 0; i < 3; ++i) material.base_color[i] = srgb_from_linear(factor[static_cast<std::size_t>(i)]);
  material.opacity = factor[3];
  return material;
}

}  // namespace

GltfScene parse_gltf_scene(const std::string& text) {
  const json root = json::parse(text);
  const auto size = [&](const char* key) { return list_at(root, key, "the file").size(); };
  const Sizes sizes{size("bufferViews"), size("accessors"), size("meshes"),
                    size("nodes"),       size("materials"), size("skins")};
  const auto with_sizes = [&](auto read) {
    return [&sizes, read](const json& item, const std::string& what) { return read(item, sizes, what); };
  };
  GltfScene scene;
  scene.views = read_all(root, "bufferViews", "buffer view", read_view);
  scene.accessors = read_all(root, "accessors", "accessor", with_sizes(read_accessor));
  scene.meshes = read_all(root, "meshes", "mesh", with_sizes(read_mesh));
  scene.nodes = read_all(root, "nodes", "node", with_sizes(read_node));
  scene.animations = read_all(root, "animations", "animation", with_sizes(read_animation));
  scene.materials = read_all(root, "materials", "material", read_material);
  scene.scenes = read_all(root, "scenes", "scene", [&](const json& item, const std::string& what) {
    return indices_at(item, "nodes", sizes.nodes, what);
  });
  scene.scene = find_index(root, "scene", scene.scenes.size(), "the file");
  list_at(root, "extensionsUsed", "the file");  // for its error
  for (const json& name : list_at(root, "extensionsRequired", "the file"))
    if (name.is_string()) scene.required.push_back(name.get<std::string>());
  return scene;
}

}  // namespace flexkey
