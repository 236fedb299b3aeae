#include "flexkey/timeline/read_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/scalar.h"
#include "flexkey/timeline/vector.h"

namespace flexkey {
namespace {

/// Letters, digits and '_', not a digit first: so "hit-4f" can only be a name and an offset.
bool is_time_name(std::string_view name) {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
  };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return !name.empty() && !is_digit(name.front()) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return is_letter(c) || is_digit(c); });
}

std::optional<Curve> checked(Curve curve, Mark where, Scope& scope) {
  const std::size_t count = curve.points.size();
  const bool is_bezier = curve.kind == Curve::Kind::bezier;
  if (is_bezier && (count < 4 || count % 3 != 1)) {
    scope.findings.error(where, fmt::format("a bezier curve has 3n + 1 points (4, 7, 10, …), not {}", count));
    return std::nullopt;
  }
  if (count < 2) {
    scope.findings.error(where, fmt::format("a curve has at least 2 points, not {}", count));
    return std::nullopt;
  }
  return curve;
}

std::optional<Curve> curve_through(Curve::Kind kind, const Node& node, Scope& scope) {
  std::optional<std::vector<Vec3>> points = read_points(node, scope);
  if (!points) return std::nullopt;
  return checked({kind, std::move(*points)}, node.where, scope);
}

std::optional<Curve> read_curve_mapping(const Node& node, std::string_view place, Scope& scope) {
  const std::optional<Fields> fields = read_fields(node, curve_keys, place, scope.findings);
  if (!fields) return std::nullopt;
  const std::vector<const Entry*>& kinds = fields->entries();
  if (kinds.empty() && node.entries.empty()) {
    scope.findings.error(node.where, fmt::format("{} needs polyline, catmull-rom or bezier", place));
  }
  if (kinds.empty()) return std::nullopt;
  if (kinds.size() > 1) {
    scope.findings.error(kinds[1]->key.where, fmt::format("a curve has one kind; '{}' stands beside '{}'",
                                                          kinds[1]->key.text, kinds[0]->key.text));
    return std::nullopt;
  }
  const std::string& name = kinds[0]->key.text;
  const Curve::Kind kind = name == "bezier"     ? Curve::Kind::bezier
                           : name == "polyline" ? Curve::Kind::polyline
                                                : Curve::Kind::catmull_rom;
  return curve_through(kind, kinds[0]->value, scope);
}

}  // namespace

void read_times(const Node& node, Scope& scope) {
  if (!is_mapping(node, "'times'", "{hit: 1.5s}", scope.findings)) return;
  for (const Entry& entry : node.entries) {
    const std::string& name = entry.key.text;
    if (!is_time_name(name)) {
      scope.findings.error(
          entry.key.where,
          fmt::format("'{}' cannot name a time; use letters, digits and _, with a letter first", name));
    }
    scope.times[name] = read_time(entry.value, scope);
  }
}

void read_named_points(const Node& node, Scope& scope) {
  if (!is_mapping(node, "'points'", "{tip: [0, 0, 1]}", scope.findings)) return;
  for (const Entry& entry : node.entries) scope.points[entry.key.text] = read_vector(entry.value, scope);
}

void read_paths(const Node& node, Scope& scope) {
  if (!is_mapping(node, "'paths'", "{arc: [[0, 0, 0], [0, 1, 0]]}", scope.findings)) return;
  for (const Entry& entry : node.entries) {
    const std::string& name = entry.key.text;
    if (name == "rest") {
      scope.findings.error(entry.key.where,
                           "a path cannot be named 'rest'; it stands for the handle's own shape");
    }
    const std::string place = fmt::format("path '{}'", name);
    scope.paths[name] = entry.value.kind == Node::Kind::list
                            ? curve_through(Curve::Kind::polyline, entry.value, scope)
                            : read_curve(entry.value, place, scope);
  }
}

std::optional<Curve> read_curve(const Node& node, std::string_view place, Scope& scope) {
  if (node.kind == Node::Kind::scalar) {
    if (node.text == "rest") return Curve{};
    return look_up(scope.paths, node, "path", "paths", scope.findings);
  }
  return read_curve_mapping(node, place, scope);
}

}  // namespace flexkey
