#include "flexkey/timeline/read_track.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "flexkey/timeline/easing.h"
#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/number.h"
#include "flexkey/timeline/scalar.h"

namespace flexkey {
namespace {

std::optional<Easing> read_bezier(const Node& node, Scope& scope) {
  if (node.items.size() != 4) {
    scope.findings.error(
        node.where,
        fmt::format("a cubic-bezier easing is [x1, y1, x2, y2], not a list of {}", node.items.size()));
    return std::nullopt;
  }
  std::array<double, 4> numbers{};
  bool good = true;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::optional<double> number = read_number(node.items[i], scope);
    const bool is_x = i % 2 == 0;
    if (number && is_x && (*number < 0 || *number > 1)) {
      scope.findings.error(node.items[i].where, fmt::format("x{} of an easing is {}, outside 0..1", i / 2 + 1,
                                                            node.items[i].text));
      good = false;
    }
    good = good && number.has_value();
    numbers[i] = number.value_or(0);
  }
  if (!good) return std::nullopt;
  return Easing{Easing::Kind::bezier, numbers[0], numbers[1], numbers[2], numbers[3]};
}

std::optional<WrittenKey> read_listed_key(const Node& item, const Easing& ease, std::string_view place,
                                          Scope& scope) {
  const std::string key_place = fmt::format("a key of {}", place);
  const std::optional<Fields> fields = read_fields(item, key_keys, key_place, scope.findings);
  if (!fields) return std::nullopt;
  WrittenKey key;
  key.ease = ease;
  if (const Node* own = fields->value("ease")) key.ease = read_easing(*own, scope).value_or(ease);
  const Node* at = require(*fields, "at", item.where, key_place, scope.findings);
  key.value = require(*fields, "value", item.where, key_place, scope.findings);
  const std::optional<double> time = at != nullptr ? read_time(*at, scope) : std::nullopt;
  if (!time || key.value == nullptr) return std::nullopt;
  key.time = *time;
  key.where = at->where;
  return key;
}

std::optional<WrittenKey> read_mapped_key(const Entry& entry, const Easing& ease, Scope& scope) {
  const std::optional<double> time = read_time(entry.key, scope);
  if (!time) return std::nullopt;
  return WrittenKey{*time, ease, &entry.value, entry.key.where};
}

void report_doubled_times(const std::vector<WrittenKey>& keys, std::string_view place, Scope& scope) {
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (keys[i].time != keys[i - 1].time) continue;
    scope.findings.error(keys[i].where,
                         fmt::format("{} has two keys at {}s", place, number_text(keys[i].time)));
  }
}

}  // namespace

std::optional<Easing> read_easing(const Node& node, Scope& scope) {
  if (node.kind == Node::Kind::list) return read_bezier(node, scope);
  std::vector<std::string> known;
  for (const NamedEasing& named : named_easings()) {
    if (node.kind == Node::Kind::scalar && node.text == named.name) return named.easing;
    known.emplace_back(named.name);
  }
  if (node.kind == Node::Kind::scalar) {
    const std::string all = fmt::format("; known are {} and [x1, y1, x2, y2]", fmt::join(known, ", "));
    scope.findings.error(node.where, fmt::format("unknown easing '{}'{}", node.text,
                                                 scope.findings.proposal(node.text, known, all)));
  } else {
    scope.findings.error(node.where,
                         fmt::format("an easing is a word or [x1, y1, x2, y2], not {}", describe(node)));
  }
  return std::nullopt;
}

Easing track_ease(const Fields& fields, Scope& scope) {
  const Node* own = fields.value("ease");
  return own != nullptr ? read_easing(*own, scope).value_or(scope.ease) : scope.ease;
}

std::vector<WrittenKey> read_keys(const Node& keys, const Easing& ease, std::string_view place,
                                  Scope& scope) {
  std::vector<WrittenKey> result;
  const bool listed = keys.kind == Node::Kind::list;
  if (!listed && !is_mapping(keys, fmt::format("'keys' in {}", place), "{0s: …, 2s: …}", scope.findings))
    return {};
  if (keys.items.empty() && keys.entries.empty()) {
    scope.findings.error(keys.where, fmt::format("{} has no keys", place));
  }
  for (const Node& item : keys.items) {
    if (const std::optional<WrittenKey> key = read_listed_key(item, ease, place, scope))
      result.push_back(*key);
  }
  for (const Entry& entry : keys.entries) {
    if (const std::optional<WrittenKey> key = read_mapped_key(entry, ease, scope)) result.push_back(*key);
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const WrittenKey& a, const WrittenKey& b) { return a.time < b.time; });
  report_doubled_times(result, place, scope);
  if (!result.empty() && result.back().time > scope.last_key) {
    scope.last_key = result.back().time;
    scope.last_key_where = result.back().where;
  }
  return result;
}

std::vector<WrittenKey> read_track(const Node& node, std::string_view place, Scope& scope) {
  const std::optional<Fields> fields = read_fields(node, track_keys, place, scope.findings);
  if (!fields) return {};
  const Easing ease = track_ease(*fields, scope);
  const Node* keys = require(*fields, "keys", node.where, place, scope.findings);
  return keys != nullptr ? read_keys(*keys, ease, place, scope) : std::vector<WrittenKey>();
}

}  // namespace flexkey
