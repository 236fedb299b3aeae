#include "flexkey/timeline/read_mesh_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <utility>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/read_path.h"
#include "flexkey/timeline/scalar.h"
#include "flexkey/timeline/words.h"

namespace flexkey {
namespace {

bool is_gltf(std::string_view file) {
  std::string lower(file);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower.ends_with(".glb") || lower.ends_with(".gltf");
}

/// "scene.glb#Node" names a node too; a '#' elsewhere belongs to the file's name.
void read_file(const Node& node, std::string_view place, MeshSource& mesh, Scope& scope) {
  mesh.where = node.where;
  mesh.file = read_path(node, place, scope).value_or("");
  for (std::size_t at = mesh.file.find('#'); at != std::string::npos; at = mesh.file.find('#', at + 1)) {
    if (!is_gltf(std::string_view(mesh.file).substr(0, at))) continue;
    const std::string name = mesh.file.substr(at + 1);
    mesh.file.resize(at);
    if (name.empty())
      scope.findings.error(node.where, fmt::format("no node is named after '#' in {}", place));
    mesh.nodes.push_back({name, node.where});
    return;
  }
}

/// One name, or nothing and an error.
void read_node_name(const Node& node, MeshSource& mesh, Scope& scope) {
  if (node.kind != Node::Kind::scalar || node.text.empty()) {
    scope.findings.error(node.where,
                         fmt::format("'nodes' takes names of nodes, not {}",
                                     node.kind == Node::Kind::scalar ? "an empty text" : describe(node)));
    return;
  }
  const auto same = [&](const NodeName& other) { return other.name == node.text; };
  if (std::any_of(mesh.nodes.begin(), mesh.nodes.end(), same)) {
    scope.findings.error(node.where, fmt::format("node '{}' is named twice", node.text));
  } else {
    mesh.nodes.push_back({node.text, node.where});
  }
}

/// `all`, a name, or a list of names.
void read_nodes(const Node& node, MeshSource& mesh, Scope& scope) {
  if (!mesh.nodes.empty()) {
    scope.findings.error(node.where, "'nodes' stands beside a file that names a node after '#'");
  } else if (node.kind == Node::Kind::scalar && node.text == "all") {
    return;
  } else if (!mesh.file.empty() && !is_gltf(mesh.file)) {
    scope.findings.error(node.where, fmt::format("'{}' has no nodes; a glTF file has", mesh.file));
  } else if (node.kind == Node::Kind::list && !node.items.empty()) {
    for (const Node& item : node.items) read_node_name(item, mesh, scope);
  } else if (node.kind == Node::Kind::list) {
    scope.findings.error(node.where, "'nodes' names no node; leave it out, or write 'nodes: all'");
  } else {
    read_node_name(node, mesh, scope);
  }
}

void read_up(const Node& node, MeshSource& mesh, Scope& scope) {
  mesh.up = read_word<UpAxis>(node, "up", {{"y", UpAxis::y}, {"z", UpAxis::z}}, scope).value_or(UpAxis::y);
  if (mesh.up == UpAxis::z && is_gltf(mesh.file))
    scope.findings.error(node.where, fmt::format("'{}' is glTF, whose upward axis is y", mesh.file));
}

}  // namespace

MeshSource read_mesh_source(const Node& node, Scope& scope) {
  using Loose = MeshSource::Loose;
  MeshSource mesh;
  mesh.where = node.where;
  if (node.kind != Node::Kind::map) {
    read_file(node, "'mesh'", mesh, scope);
    return mesh;
  }
  const std::optional<Fields> fields = read_fields(node, mesh_keys, "'mesh'", scope.findings);
  if (const Node* file = require(*fields, "file", node.where, "'mesh'", scope.findings))
    read_file(*file, "'file' in 'mesh'", mesh, scope);
  if (const Node* nodes = fields->value("nodes")) read_nodes(*nodes, mesh, scope);
  if (const Node* loose = fields->value("loose")) {
    mesh.loose =
        read_word<Loose>(*loose, "loose",
                         {{"attach", Loose::attach}, {"hold", Loose::hold}, {"error", Loose::error}}, scope)
            .value_or(Loose::attach);
  }
  if (const Node* up = fields->value("up")) read_up(*up, mesh, scope);
  if (const Node* weld = fields->value("weld")) mesh.weld = read_distance(*weld, scope).value_or(Length{});
  return mesh;
}

}  // namespace flexkey
