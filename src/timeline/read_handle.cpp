#include "flexkey/timeline/read_handle.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>
#include <variant>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/read_active.h"
#include "flexkey/timeline/read_motion.h"
#include "flexkey/timeline/read_selection.h"
#include "flexkey/timeline/scalar.h"
#include "flexkey/timeline/vector.h"

namespace flexkey {
namespace {

/// Two motions that exclude each other.
struct Exclusion {
  std::string_view one, other;
};

constexpr std::array<Exclusion, 5> exclusions = {{
    {"move", "to"},
    {"curve", "move"},
    {"curve", "to"},
    {"curve", "rotate"},
    {"curve", "scale"},
}};

void check_exclusions(const Fields& fields, const std::string& place, Scope& scope) {
  for (const auto& [one, other] : exclusions) {
    const Entry* first = fields.find(one);
    const Entry* second = fields.find(other);
    if (first == nullptr || second == nullptr) continue;
    if (second < first) std::swap(first, second);  // entries lie in the file's order
    scope.findings.error(second->key.where, fmt::format("'{}' and '{}' exclude each other in {}",
                                                        first->key.text, second->key.text, place));
  }
}

/// A curve lays an ordered chain of vertices, which only a path selects, and without more rings around it.
void check_curve(const Entry& curve, const Selection& select, const std::string& place, Scope& scope) {
  if (!std::holds_alternative<SelectPath>(select.kind)) {
    scope.findings.error(curve.key.where,
                         fmt::format("'curve' in {} needs an ordered chain of vertices: select it "
                                     "with 'path'",
                                     place));
  } else if (select.grow > 0) {
    scope.findings.error(curve.key.where,
                         fmt::format("'curve' in {} needs the chain alone, without 'grow'", place));
  }
}

double read_weight(const Node& node, Scope& scope) {
  const double weight = read_number(node, scope).value_or(1);
  if (weight > 0 && weight <= 1) return weight;
  scope.findings.error(node.where,
                       fmt::format("weight {} is outside 0..1 (above 0, a soft handle, to 1, which is met "
                                   "exactly)",
                                   node.text));
  return 1;
}

std::optional<Handle> read_handle(const Entry& entry, Scope& scope) {
  const std::string place = fmt::format("handle '{}'", entry.key.text);
  const std::optional<Fields> fields = read_fields(entry.value, handle_keys, place, scope.findings);
  if (!fields) return std::nullopt;
  Handle handle;
  handle.name = entry.key.text;
  handle.where = entry.key.where;
  if (const Node* pivot = fields->value("pivot")) handle.pivot = read_point(*pivot, scope);
  const auto motion_place = [&](std::string_view key) { return fmt::format("'{}' of {}", key, place); };
  if (const Node* node = fields->value("move")) handle.move = read_move(*node, motion_place("move"), scope);
  if (const Node* node = fields->value("to")) handle.to = read_to(*node, motion_place("to"), scope);
  if (const Node* node = fields->value("rotate"))
    handle.rotate = read_rotate(*node, motion_place("rotate"), scope);
  if (const Node* node = fields->value("scale"))
    handle.scale = read_scale(*node, motion_place("scale"), scope);
  if (const Node* node = fields->value("curve"))
    handle.curve = read_curve_track(*node, motion_place("curve"), scope);
  if (const Node* node = fields->value("weight")) handle.weight = read_weight(*node, scope);
  read_activity(*fields, place, scope, handle);
  check_exclusions(*fields, place, scope);
  const Node* select = require(*fields, "select", entry.key.where, place, scope.findings);
  if (select == nullptr) return std::nullopt;
  std::optional<Selection> selection = read_selection(*select, fmt::format("'select' of {}", place), scope);
  if (!selection) return std::nullopt;
  if (const Entry* curve = fields->find("curve")) check_curve(*curve, *selection, place, scope);
  handle.select = std::move(*selection);
  return handle;
}

}  // namespace

std::vector<Handle> read_handles(const Node& node, Scope& scope) {
  if (!is_mapping(node, "'handles'", "{tip: {select: {axis: z, above: 99%}}}", scope.findings)) return {};
  if (node.entries.empty()) scope.findings.error(node.where, "'handles' names no handle");
  std::vector<Handle> handles;
  for (const Entry& entry : node.entries) {
    if (std::optional<Handle> handle = read_handle(entry, scope)) handles.push_back(std::move(*handle));
  }
  return handles;
}

}  // namespace flexkey
