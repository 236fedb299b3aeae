#include "flexkey/timeline/read_rigid.h"

#include <fmt/format.h>

#include <utility>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/read_selection.h"

namespace flexkey {

std::vector<RigidSelection> read_rigid(const Node& node, Scope& scope) {
  if (!is_mapping(node, "'rigid'", "{teeth: {group: teeth}}", scope.findings)) return {};
  std::vector<RigidSelection> regions;
  for (const Entry& entry : node.entries) {
    const std::string place = fmt::format("rigid region '{}'", entry.key.text);
    if (entry.value.kind == Node::Kind::null) {
      scope.findings.error(entry.key.where, fmt::format("{} has no selection", place));
    } else if (std::optional<Selection> select = read_selection(entry.value, place, scope)) {
      regions.push_back({entry.key.text, entry.key.where, std::move(*select)});
    }
  }
  return regions;
}

}  // namespace flexkey
