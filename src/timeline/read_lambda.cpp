#include "flexkey/timeline/read_lambda.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "flexkey/mesh/spelling.h"
#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/number.h"
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

std::vector<WrittenKey> read_lambda_keys(const Node& node, Scope& scope) {
  if (!is_track(node, scope)) return read_keys(node, scope.ease, "'lambda'", scope);
  const std::optional<Fields> fields = read_fields(node, lambda_keys, "'lambda'", scope.findings);
  const Easing ease = track_ease(*fields, scope);
  const Node* keys = require(*fields, "keys", node.where, "'lambda'", scope.findings);
  return keys != nullptr ? read_keys(*keys, ease, "'lambda'", scope) : std::vector<WrittenKey>();
}

}  // namespace

Track<double> read_lambda(const Node& node, Scope& scope) {
  if (node.kind == Node::Kind::scalar) {
    const std::optional<double> value = read_value(node, scope);
    return value ? Track<double>{{0, *value, {}}} : Track<double>{};
  }
  if (node.kind == Node::Kind::list) {
    scope.findings.error(node.where,
                         "'lambda' is a number, values by time ({2s: 0, 4s: 1}) or {keys, ease}, not a list; "
                         "values to run one after another stand under 'sweep'");
    return {};
  }
  return track_of<double>(read_lambda_keys(node, scope),
                          [&](const Node& value) { return read_value(value, scope); });
}

std::vector<double> read_sweep(const Node& node, Scope& scope) {
  if (!is_mapping(node, "'sweep'", "{lambda: [0, 0.5, 1]}", scope.findings)) return {};
  for (const Entry& entry : node.entries) {
    if (entry.key.text == "lambda") continue;
    scope.findings.error(
        entry.key.where,
        fmt::format("'{}' cannot be swept; only lambda can be swept in this version", entry.key.text));
  }
  const Entry* lambda = node.find("lambda");
  if (lambda == nullptr) return {};
  if (lambda->value.kind != Node::Kind::list || lambda->value.items.empty()) {
    scope.findings.error(lambda->value.where, "a sweep takes a list of values, such as [0, 0.5, 1]");
    return {};
  }
  std::vector<double> values;
  for (const Node& item : lambda->value.items) {
    const std::optional<double> value = read_value(item, scope);
    if (!value) continue;
    if (std::find(values.begin(), values.end(), *value) != values.end()) {
      scope.findings.error(item.where, fmt::format("lambda {} is in the sweep twice", number_text(*value)));
    } else {
      values.push_back(*value);
    }
  }
  return values;
}

}  // namespace flexkey
