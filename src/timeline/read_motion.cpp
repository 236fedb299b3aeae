#include "flexkey/timeline/read_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/number.h"
#include "flexkey/timeline/read_names.h"
#include "flexkey/timeline/read_track.h"
#include "flexkey/timeline/rotation.h"
#include "flexkey/timeline/scalar.h"
#include "flexkey/timeline/vector.h"

namespace flexkey {
namespace {

std::optional<Vec3> read_factors(const Node& node, Scope& scope) {
  std::optional<Vec3> factors;
  if (node.kind == Node::Kind::scalar) {
    const std::optional<double> factor = read_number(node, scope);
    if (factor) factors = Vec3::Constant(*factor);
  } else {
    factors = read_vector(node, scope);
  }
  if (!factors || factors->minCoeff() > 0) return factors;
  scope.findings.error(
      node.where, "scale factors are above 0; 0 would collapse the handle and below 0 turn it inside out");
  return std::nullopt;
}

/// A key {axis, angle}.
std::optional<AxisAngle> read_turn(const Node& node, std::string_view place, Scope& scope) {
  const std::string key_place = fmt::format("a key of {}", place);
  const std::optional<Fields> fields = read_fields(node, turn_keys, key_place, scope.findings);
  if (!fields) return std::nullopt;
  const Node* axis_node = require(*fields, "axis", node.where, key_place, scope.findings);
  const Node* angle_node = require(*fields, "angle", node.where, key_place, scope.findings);
  const std::optional<Vec3> axis = axis_node != nullptr ? read_axis(*axis_node, scope) : std::nullopt;
  const std::optional<double> angle = angle_node != nullptr ? read_angle(*angle_node, scope) : std::nullopt;
  if (!axis || !angle) return std::nullopt;
  return AxisAngle{*axis, *angle};
}

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

}  // namespace

Track<Vec3> read_move(const Node& node, std::string_view place, Scope& scope) {
  return track_of<Vec3>(read_track(node, place, scope),
                        [&](const Node& value) { return read_vector(value, scope); });
}

Track<Vec3> read_to(const Node& node, std::string_view place, Scope& scope) {
  return track_of<Vec3>(read_track(node, place, scope),
                        [&](const Node& value) { return read_point(value, scope); });
}

Track<Vec3> read_scale(const Node& node, std::string_view place, Scope& scope) {
  return track_of<Vec3>(read_track(node, place, scope),
                        [&](const Node& value) { return read_factors(value, scope); });
}

Track<AxisAngle> read_rotate(const Node& node, std::string_view place, Scope& scope) {
  const std::optional<Fields> fields = read_fields(node, rotate_keys, place, scope.findings);
  if (!fields || node.find("euler") != nullptr) return {};
  Easing ease = scope.ease;
  if (const Node* own = fields->value("ease")) ease = read_easing(*own, scope).value_or(ease);
  const Node* keys_node = require(*fields, "keys", node.where, place, scope.findings);
  const Node* axis_node = fields->value("axis");
  const std::optional<Vec3> axis = axis_node != nullptr ? read_axis(*axis_node, scope) : std::nullopt;
  if (keys_node == nullptr) return {};
  const std::vector<WrittenKey> keys = read_keys(*keys_node, ease, place, scope);
  if (fields->lacks("axis") && !std::all_of(keys.begin(), keys.end(), has_own_axis)) {
    scope.findings.error(node.where,
                         fmt::format("{} needs 'axis': x, y, z or a vector, here or in each key", place));
  }
  const Track<AxisAngle> track =
      track_of<AxisAngle>(keys, [&](const Node& value) -> std::optional<AxisAngle> {
        if (value.kind == Node::Kind::map) return read_turn(value, place, scope);
        const std::optional<double> angle = read_angle(value, scope);
        if (!angle) return std::nullopt;
        return AxisAngle{axis.value_or(Vec3::UnitZ()), *angle};
      });
  if (axis || fields->lacks("axis")) check_turns(track, keys, scope);
  return track;
}

Track<Curve> read_curve_track(const Node& node, std::string_view place, Scope& scope) {
  const std::string curve_place = fmt::format("a key of {}", place);
  return track_of<Curve>(read_track(node, place, scope),
                         [&](const Node& value) { return read_curve(value, curve_place, scope); });
}

}  // namespace flexkey
