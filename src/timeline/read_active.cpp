#include "flexkey/timeline/read_active.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "flexkey/timeline/number.h"
#include "flexkey/timeline/scalar.h"

namespace flexkey {
namespace {

std::optional<Interval> read_interval(const Node& node, const std::string& place, Scope& scope) {
  if (node.kind != Node::Kind::list || node.items.size() != 2) {
    scope.findings.error(
        node.where, fmt::format("'active' of {} is [from, to) such as [1s, 2s], or a list of such, not {}",
                                place, describe(node)));
    return std::nullopt;
  }
  const std::optional<double> from = read_time(node.items[0], scope), to = read_time(node.items[1], scope);
  if (!from || !to) return std::nullopt;
  if (*from < *to) return Interval{*from, *to};
  scope.findings.error(node.where, fmt::format("'active' of {} is from {} to {}, which is no time at all",
                                               place, node.items[0].text, node.items[1].text));
  return std::nullopt;
}

bool is_list_of_lists(const Node& node) {
  return node.kind == Node::Kind::list && !node.items.empty() && node.items[0].kind == Node::Kind::list;
}

std::vector<Interval> read_active(const Node& node, const std::string& place, Scope& scope) {
  std::vector<Interval> intervals;
  if (!is_list_of_lists(node)) {
    if (const std::optional<Interval> interval = read_interval(node, place, scope)) intervals = {*interval};
    return intervals;
  }
  for (const Node& item : node.items) {
    const std::optional<Interval> interval = read_interval(item, place, scope);
    if (!interval) continue;
    if (!intervals.empty() && interval->from < intervals.back().to) {
      scope.findings.error(item.where,
                           fmt::format("'active' of {} has times that overlap or go back", place));
    } else {
      intervals.push_back(*interval);
    }
  }
  return intervals;
}

double read_fade(const Node& node, Scope& scope) {
  if (node.kind == Node::Kind::scalar && trimmed(node.text).starts_with('-')) {
    scope.findings.error(node.where, fmt::format("fade {} is below 0", node.text));
    return 0;
  }
  return read_time(node, scope).value_or(0);
}

/// A fade takes place twice in each interval, as the handle takes hold and as it lets go.
void check_fade(const Node& node, const std::string& place, const Handle& handle, Scope& scope) {
  constexpr double rounding = 1e-9;
  const auto is_short = [&](const Interval& interval) {
    return 2 * handle.fade > interval.to - interval.from + rounding;
  };
  const auto found = std::find_if(handle.active.begin(), handle.active.end(), is_short);
  if (found == handle.active.end()) return;
  scope.findings.error(
      node.where,
      fmt::format("fade {} does not fit twice into the {}s that {} is active from {}s on", node.text,
                  number_text(found->to - found->from), place, number_text(found->from)));
}

}  // namespace

void read_activity(const Fields& fields, const std::string& place, Scope& scope, Handle& handle) {
  if (const Node* node = fields.value("active")) handle.active = read_active(*node, place, scope);
  const Entry* fade = fields.find("fade");
  if (fade == nullptr) return;
  handle.fade = read_fade(fade->value, scope);
  if (fields.lacks("active")) {
    scope.findings.error(
        fade->key.where,
        fmt::format("'fade' of {} says how it takes hold and lets go; say when, with 'active'", place));
  }
  check_fade(fade->value, place, handle, scope);
}

}  // namespace flexkey
