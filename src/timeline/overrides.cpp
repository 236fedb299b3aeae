#include "flexkey/timeline/overrides.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "flexkey/timeline/number.h"
#include "flexkey/timeline/source_text.h"

namespace flexkey {
namespace {

/// The value's tree; its errors, found at places of the value's own text, all belong to the override.
std::optional<Node> read_value(const std::string& text, Mark where, Findings& findings) {
  Findings own;
  std::optional<Node> value;
  try {
    value = marked(parse_yaml(text, own), where);
  } catch (const YamlError& error) {
    own.error(error.where(), error.what());
  }
  for (const Diagnostic& error : own.errors()) findings.error(where, error.message);
  return own.has_errors() ? std::nullopt : value;
}

/// The first part of a key path in a mapping: the longest key that is there, else what stands before the
/// first dot.
std::string_view first_part(const Node& map, std::string_view path) {
  std::string_view longest;
  for (const Entry& entry : map.entries) {
    const std::string& key = entry.key.text;
    const bool begins = path.starts_with(key) && (path.size() == key.size() || path[key.size()] == '.');
    if (begins && key.size() > longest.size()) longest = path.substr(0, key.size());
  }
  return longest.empty() ? path.substr(0, path.find('.')) : longest;
}

/// The child that a part of the path names, made if it is missing; null if there can be none.
Node* find_child(Node& node, std::string_view part, Mark where) {
  if (node.kind == Node::Kind::list) {
    const std::optional<int> index = parse_whole(part);
    const bool exists = index && *index >= 0 && static_cast<std::size_t>(*index) < node.items.size();
    return exists ? &node.items[static_cast<std::size_t>(*index)] : nullptr;
  }
  for (Entry& entry : node.entries) {
    if (entry.key.text == part) return &entry.value;
  }
  Entry& made = node.entries.emplace_back();
  made.key.kind = Node::Kind::scalar;
  made.key.text = part;
  made.key.where = made.value.where = where;
  return &made.value;
}

std::string missing_item(const Node& list, std::string_view path, std::string_view part) {
  return fmt::format("'{}' is no item of the list '{}', which has {}", part, path, list.items.size());
}

}  // namespace

Node marked(Node node, Mark where) {
  node.where = where;
  for (Node& item : node.items) item = marked(std::move(item), where);
  for (Entry& entry : node.entries) {
    entry.key.where = where;
    entry.value = marked(std::move(entry.value), where);
  }
  return node;
}

Node with_override(Node root, const Override& change, int number, Findings& findings) {
  const Mark where{0, number};
  std::optional<Node> value = read_value(change.value, where, findings);
  if (value) put_value(root, {change.key_path, where}, std::move(*value), findings);
  return root;
}

void put_value(Node& root, const KeyPath& key, Node value, Findings& findings) {
  const auto& [path_text, where] = key;
  const std::string_view path = path_text;
  Node* place = &root;
  std::size_t at = 0;
  while (at <= path.size()) {
    const std::string_view above = path.substr(0, at == 0 ? 0 : at - 1);
    if (place->kind == Node::Kind::null) place->kind = Node::Kind::map;
    if (place->kind == Node::Kind::scalar) {
      findings.error(where,
                     fmt::format("'{}' is '{}', not a mapping; set '{}' itself", above, place->text, above));
      return;
    }
    const std::string_view part = first_part(*place, path.substr(at));
    if (part.empty()) {
      findings.error(where, "a key path is keys joined by dots, such as solver.iterations");
      return;
    }
    Node* child = find_child(*place, part, where);
    if (child == nullptr) {
      findings.error(where, missing_item(*place, above, part));
      return;
    }
    place = child;
    at += part.size() + 1;
  }
  *place = std::move(value);
}

}  // namespace flexkey
