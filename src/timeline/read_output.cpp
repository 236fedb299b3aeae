#include "flexkey/timeline/read_output.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/scalar.h"
#include "flexkey/timeline/words.h"

namespace flexkey {
namespace {

/// The text of a path, or nothing and an error.
std::optional<std::string> read_file_path(const Node& node, std::string_view place, Scope& scope) {
  if (node.kind == Node::Kind::scalar && !node.text.empty()) return node.text;
  const std::string found = node.kind == Node::Kind::scalar ? "an empty text" : describe(node);
  scope.findings.error(node.where, fmt::format("{} is a path, not {}", place, found));
  return std::nullopt;
}

GltfOutput gltf_at(const Node& path, std::string_view place, Scope& scope) {
  return {.path = read_file_path(path, place, scope).value_or(""), .where = path.where};
}

enum class Profile { exact };

/// The file is always written with one target a frame; another profile asks for fewer.
void check_profile(const Node& node, Scope& scope) {
  if (node.kind == Node::Kind::scalar && (node.text == "compat" || node.text == "web")) {
    scope.findings.warning(node.where,
                           fmt::format("profile '{}' is not built yet; exact is written", node.text));
    return;
  }
  read_word<Profile>(node, "profile",
                     {{"compat", std::nullopt}, {"web", std::nullopt}, {"exact", Profile::exact}}, scope);
}

constexpr int most_targets = 65535;  // more overflow the 16-bit counts of common loaders

std::optional<int> read_max_targets(const Node& node, Scope& scope) {
  const std::optional<int> targets = read_whole(node, scope);
  if (!targets || (*targets >= 1 && *targets <= most_targets)) return targets;
  scope.findings.error(node.where, fmt::format("max_targets {} is outside 1..{}", node.text, most_targets));
  return std::nullopt;
}

GltfOutput read_gltf_mapping(const Node& node, Scope& scope) {
  const std::optional<Fields> fields = read_fields(node, gltf_keys, "'gltf'", scope.findings);
  if (!fields) return {};
  GltfOutput output;
  const Node* path = require(*fields, "path", node.where, "'gltf'", scope.findings);
  if (path != nullptr) output = gltf_at(*path, "'path' in 'gltf'", scope);
  if (const Node* profile = fields->value("profile")) check_profile(*profile, scope);
  if (const Node* tolerance = fields->value("tolerance")) read_tolerance(*tolerance, scope);
  if (const Node* targets = fields->value("max_targets")) {
    output.max_targets = read_max_targets(*targets, scope).value_or(output.max_targets);
  }
  if (const Node* normals = fields->value("normals")) {
    output.normals =
        read_word<bool>(*normals, "normals", {{"smooth", true}, {"none", false}}, scope).value_or(true);
  }
  return output;
}

}  // namespace

MeshSource read_mesh_source(const Node& node, Scope& scope) {
  using Loose = MeshSource::Loose;
  MeshSource mesh;
  mesh.where = node.where;
  if (node.kind != Node::Kind::map) {
    mesh.file = read_file_path(node, "'mesh'", scope).value_or("");
    return mesh;
  }
  const std::optional<Fields> fields = read_fields(node, mesh_keys, "'mesh'", scope.findings);
  if (const Node* file = require(*fields, "file", node.where, "'mesh'", scope.findings)) {
    mesh.file = read_file_path(*file, "'file' in 'mesh'", scope).value_or("");
    mesh.where = file->where;
  }
  if (const Node* loose = fields->value("loose")) {
    mesh.loose =
        read_word<Loose>(*loose, "loose",
                         {{"attach", Loose::attach}, {"hold", Loose::hold}, {"error", Loose::error}}, scope)
            .value_or(Loose::attach);
  }
  if (const Node* weld = fields->value("weld")) mesh.weld = read_distance(*weld, scope).value_or(Length{});
  return mesh;
}

GltfOutput read_output(const Node& node, Scope& scope) {
  if (node.kind != Node::Kind::map) return gltf_at(node, "'output'", scope);
  const std::optional<Fields> fields = read_fields(node, output_keys, "'output'", scope.findings);
  const Node* gltf = fields->value("gltf");
  if (gltf == nullptr) return {};
  return gltf->kind == Node::Kind::map ? read_gltf_mapping(*gltf, scope) : gltf_at(*gltf, "'gltf'", scope);
}

}  // namespace flexkey
