#include "flexkey/timeline/read_path.h"

#include <fmt/format.h>

namespace flexkey {

std::optional<std::string> read_path(const Node& node, std::string_view place, Scope& scope) {
  if (node.kind == Node::Kind::scalar && !node.text.empty()) return node.text;
  const std::string found = node.kind == Node::Kind::scalar ? "an empty text" : describe(node);
  scope.findings.error(node.where, fmt::format("{} is a path, not {}", place, found));
  return std::nullopt;
}

}  // namespace flexkey
