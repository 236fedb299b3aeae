#include "flexkey/timeline/read_rotate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/number.h"
#include "flexkey/timeline/read_track.h"
#include "flexkey/timeline/rotation.h"
#include "flexkey/timeline/scalar.h"
#include "flexkey/timeline/vector.h"

namespace flexkey {
namespace {

bool has_own_axis(const WrittenKey& key) {
  return key.value->kind == Node::Kind::map;
}

/// What is wrong with the turn between two keys that are slerped: it would be another one than the file says.
std::string turn_problem(const Key<AxisAngle>& before, const Key<AxisAngle>& after) {
  constexpr double half_turn = std::numbers::pi * (1 + 1e-9);
  const double largest_angle = std::max(std::abs(before.value.angle), std::abs(after.value.angle));
  if (!same_axis(before.value, after.value) && largest_angle > 2 * half_turn) {
    return "keys about different axes turn at most 360deg; more turns need one 'axis' for all keys";
  }
  const double turn = turn_between(before.value, after.value);
  if (turn <= half_turn) return {};
  return fmt::format(
      "the turn from the key at {}s to this one is {:.5g}deg, past 180deg; add a key between, or give "
      "one 'axis' for all keys",
      number_text(before.time), turn / std::numbers::pi * 180);
}

void check_turns(const Track<AxisAngle>& track, const std::vector<WrittenKey>& keys, Scope& scope) {
  const bool all_read = track.size() == keys.size();
  if (!all_read || std::none_of(keys.begin(), keys.end(), has_own_axis)) return;
  for (std::size_t i = 1; i < track.size(); ++i) {
    const std::string problem = turn_problem(track[i - 1], track[i]);
    if (!problem.empty()) scope.findings.error(keys[i].value->where, problem);
  }
}

/// Angles about one axis, or about an axis a key.
Track<AxisAngle> read_turns(const Node& node, const Fields& fields, std::string_view place, Scope& scope) {
  const Easing ease = track_ease(fields, scope);
  const Node* keys_node = require(fields, "keys", node.where, place, scope.findings);
  const Node* axis_node = fields.value("axis");
  const std::optional<Vec3> axis = axis_node != nullptr ? read_axis(*axis_node, scope) : std::nullopt;
  if (keys_node == nullptr) return {};
  const std::vector<WrittenKey> keys = read_keys(*keys_node, ease, place, scope);
  if (fields.lacks("axis") && !std::all_of(keys.begin(), keys.end(), has_own_axis)) {
    scope.findings.error(node.where,
                         fmt::format("{} needs 'axis': x, y, z or a vector, here or in each key", place));
  }
  const Track<AxisAngle> track =
      track_of<AxisAngle>(keys, [&](const Node& value) -> std::optional<AxisAngle> {
        if (value.kind == Node::Kind::map) return read_turn(value, fmt::format("a key of {}", place), scope);
        const std::optional<double> angle = read_angle(value, scope);
        if (!angle) return std::nullopt;
        return AxisAngle{axis.value_or(Vec3::UnitZ()), *angle};
      });
  if (axis || fields.lacks("axis")) check_turns(track, keys, scope);
  return track;
}

/// "zxy": each axis once.
std::optional<std::array<int, 3>> read_order(const Node& node, Scope& scope) {
  std::array<int, 3> order{};
  bool is_order = node.kind == Node::Kind::scalar && node.text.size() == 3;
  for (std::size_t i = 0; is_order && i < 3; ++i) {
    const std::size_t axis = std::string_view("xyz").find(node.text[i]);
    is_order = axis != std::string_view::npos && node.text.find(node.text[i]) == i;
    order[i] = static_cast<int>(axis);
  }
  if (is_order) return order;
  scope.findings.error(node.where,
                       fmt::format("'euler' is an order of the axes such as xyz, not {}", describe(node)));
  return std::nullopt;
}

EulerTrack read_euler(const Node& node, const Fields& fields, std::string_view place, Scope& scope) {
  EulerTrack euler;
  euler.order = read_order(*fields.value("euler"), scope).value_or(euler.order);
  if (const Entry* axis = fields.find("axis"))
    scope.findings.error(axis->key.where, fmt::format("'axis' and 'euler' exclude each other in {}", place));
  const Node* keys = require(fields, "keys", node.where, place, scope.findings);
  if (keys == nullptr) return euler;
  euler.keys = track_of<Vec3>(read_keys(*keys, track_ease(fields, scope), place, scope),
                              [&](const Node& value) { return read_angles(value, scope); });
  return euler;
}

}  // namespace

std::optional<AxisAngle> read_turn(const Node& node, std::string_view place, Scope& scope) {
  const std::optional<Fields> fields = read_fields(node, turn_keys, place, scope.findings);
  if (!fields) return std::nullopt;
  const Node* axis_node = require(*fields, "axis", node.where, place, scope.findings);
  const Node* angle_node = require(*fields, "angle", node.where, place, scope.findings);
  const std::optional<Vec3> axis = axis_node != nullptr ? read_axis(*axis_node, scope) : std::nullopt;
  const std::optional<double> angle = angle_node != nullptr ? read_angle(*angle_node, scope) : std::nullopt;
  if (!axis || !angle) return std::nullopt;
  return AxisAngle{*axis, *angle};
}

std::optional<Vec3> read_angles(const Node& node, Scope& scope) {
  if (node.kind != Node::Kind::list || node.items.size() != 3) {
    scope.findings.error(node.where,
                         fmt::format("three angles [x, y, z] such as [0deg, 90deg, 0deg] belong here, not {}",
                                     describe(node)));
    return std::nullopt;
  }
  const std::optional<double> x = read_angle(node.items[0], scope), y = read_angle(node.items[1], scope),
                              z = read_angle(node.items[2], scope);
  if (!x || !y || !z) return std::nullopt;
  return Vec3(*x, *y, *z);
}

Rotation read_rotate(const Node& node, std::string_view place, Scope& scope) {
  const std::optional<Fields> fields = read_fields(node, rotate_keys, place, scope.findings);
  if (!fields) return {};
  if (fields->value("euler") != nullptr) return {{}, read_euler(node, *fields, place, scope)};
  return {read_turns(node, *fields, place, scope), {}};
}

}  // namespace flexkey
