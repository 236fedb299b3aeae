#include "flexkey/timeline/read_lambda.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "flexkey/mesh/spelling.h"
#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/number.h"
#include "flexkey/timeline/read_selection.h"
#include "flexkey/timeline/read_track.h"
#include "flexkey/timeline/scalar.h"

namespace flexkey {
namespace {

std::optional<double> read_value(const Node& node, Scope& scope) {
  const std::optional<double> value = read_number(node, scope);
  if (!value) return std::nullopt;
  if (*value >= 0 && *value <= 1) return *value + 0.0;  // -0 becomes 0
  scope.findings.error(node.where,
                       fmt::format("lambda {} is outside 0..1 (0 smooth, 1 most rigid)", node.text));
  return std::nullopt;
}

/// Whether a mapping means {keys, ease, regions} and not {time: value}, misspelt keys included.
bool is_track(const Node& node, const Scope& scope) {
  const std::vector<std::string> known = known_words(lambda_keys);
  return std::any_of(node.entries.begin(), node.entries.end(), [&](const Entry& entry) {
    const std::string& key = entry.key.text;
    return !scope.times.contains(key) && !nearest_word(key, known).empty();
  });
}

Track<double> values_of(const std::vector<WrittenKey>& keys, Scope& scope) {
  return track_of<double>(keys, [&](const Node& value) { return read_value(value, scope); });
}

Track<double> constant(const Node& node, Scope& scope) {
  const std::optional<double> value = read_value(node, scope);
  return value ? Track<double>{{0, *value, {}}} : Track<double>{};
}

/// A number, {time: value} or {keys, ease}.
Track<double> read_region_value(const Node& node, std::string_view place, Scope& scope) {
  if (node.kind == Node::Kind::scalar) return constant(node, scope);
  return values_of(
      is_track(node, scope) ? read_track(node, place, scope) : read_keys(node, scope.ease, place, scope),
      scope);
}

std::optional<LambdaRegion> read_region(const Node& node, Scope& scope) {
  constexpr std::string_view place = "a region of 'lambda'";
  const std::optional<Fields> fields = read_fields(node, region_keys, place, scope.findings);
  if (!fields) return std::nullopt;
  const Node* select = require(*fields, "select", node.where, place, scope.findings);
  const Node* value = require(*fields, "value", node.where, place, scope.findings);
  LambdaRegion region;
  region.where = node.where;
  if (const Node* feather = fields->value("feather"))
    region.feather = read_distance(*feather, scope).value_or(region.feather);
  if (value != nullptr) region.lambda = read_region_value(*value, "'value' of a region of 'lambda'", scope);
  std::optional<Selection> selection =
      select != nullptr ? read_selection(*select, "'select' of a region of 'lambda'", scope) : std::nullopt;
  if (!selection || region.lambda.empty()) return std::nullopt;
  region.select = std::move(*selection);
  return region;
}

std::vector<LambdaRegion> read_regions(const Node& node, Scope& scope) {
  std::vector<LambdaRegion> regions;
  if (node.kind != Node::Kind::list) {
    scope.findings.error(
        node.where, fmt::format("'regions' is a list of {}, not {}", region_keys.example, describe(node)));
    return regions;
  }
  for (const Node& item : node.items)
    if (std::optional<LambdaRegion> region = read_region(item, scope)) regions.push_back(std::move(*region));
  return regions;
}

/// {keys, ease, regions}; with regions alone the rest of the surface has the default.
Lambda read_lambda_mapping(const Node& node, Scope& scope) {
  const std::optional<Fields> fields = read_fields(node, lambda_keys, "'lambda'", scope.findings);
  Lambda lambda;
  const Easing ease = track_ease(*fields, scope);
  const Node* regions = fields->value("regions");
  if (regions != nullptr) lambda.regions = read_regions(*regions, scope);
  const Node* keys = regions != nullptr ? fields->value("keys")
                                        : require(*fields, "keys", node.where, "'lambda'", scope.findings);
  if (keys != nullptr)
    lambda.keys = keys->kind == Node::Kind::scalar
                      ? constant(*keys, scope)
                      : values_of(read_keys(*keys, ease, "'lambda'", scope), scope);
  if (keys == nullptr && regions != nullptr) lambda.keys = {{0, default_lambda, {}}};
  return lambda;
}

}  // namespace

Lambda read_lambda(const Node& node, Scope& scope) {
  if (node.kind == Node::Kind::scalar) return {constant(node, scope), {}};
  if (node.kind == Node::Kind::list) {
    scope.findings.error(node.where,
                         "'lambda' is a number, values by time ({2s: 0, 4s: 1}) or {keys, ease}, not a list; "
                         "values to run one after another stand under 'sweep'");
    return {};
  }
  if (is_track(node, scope)) return read_lambda_mapping(node, scope);
  return {values_of(read_keys(node, scope.ease, "'lambda'", scope), scope), {}};
}

}  // namespace flexkey
