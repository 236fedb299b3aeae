#include "flexkey/timeline/read_html_output.h"

#include <optional>
#include <string_view>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/read_path.h"

namespace flexkey {
namespace {

HtmlOutput page_at(const Node& path, std::string_view place, Scope& scope) {
  return {.path = read_path(path, place, scope).value_or(""), .where = path.where};
}

}  // namespace

HtmlOutput read_html_output(const Node& node, Scope& scope) {
  if (node.kind != Node::Kind::map) return page_at(node, "'html'", scope);
  const std::optional<Fields> fields = read_fields(node, file_keys, "'html'", scope.findings);
  const Node* path = fields ? require(*fields, "path", node.where, "'html'", scope.findings) : nullptr;
  return path != nullptr ? page_at(*path, "'path' in 'html'", scope) : HtmlOutput{};
}

}  // namespace flexkey
