#include "flexkey/timeline/read_attachments.h"

#include <fmt/format.h>

#include <utility>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/read_selection.h"

namespace flexkey {
namespace {

std::optional<Attachment> read_attachment(const Node& node, Scope& scope) {
  constexpr std::string_view place = "an item of 'attach'";
  const std::optional<Fields> fields = read_fields(node, attach_keys, place, scope.findings);
  if (!fields) return std::nullopt;
  const Node* select = require(*fields, "select", node.where, place, scope.findings);
  std::optional<Selection> riding =
      select != nullptr ? read_selection(*select, "'select' in 'attach'", scope) : std::nullopt;
  std::optional<Selection> ridden;
  if (const Node* to = fields->value("to")) ridden = read_selection(*to, "'to' in 'attach'", scope);
  if (!riding) return std::nullopt;
  return Attachment{node.where, std::move(*riding), std::move(ridden)};
}

}  // namespace

std::vector<Attachment> read_attachments(const Node& node, Scope& scope) {
  std::vector<Attachment> attachments;
  if (node.kind != Node::Kind::list) {
    scope.findings.error(
        node.where, fmt::format("'attach' is a list of {}, not {}", attach_keys.example, describe(node)));
    return attachments;
  }
  for (const Node& item : node.items)
    if (std::optional<Attachment> one = read_attachment(item, scope)) attachments.push_back(std::move(*one));
  return attachments;
}

}  // namespace flexkey
