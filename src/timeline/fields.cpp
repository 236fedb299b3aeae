#include "flexkey/timeline/fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "flexkey/mesh/spelling.h"

namespace flexkey {
namespace {

const KeySpec* find_spec(const MappingSpec& spec, std::string_view name) {
  const auto found =
      std::find_if(spec.keys.begin(), spec.keys.end(), [&](const KeySpec& k) { return k.name == name; });
  return found == spec.keys.end() ? nullptr : &*found;
}

/// A time that stands beside `keys` and not under it, as in {move: {0s: …}}.
bool is_stray_time(const std::string& key, const MappingSpec& spec) {
  return find_spec(spec, "keys") != nullptr && !key.empty() && key.front() >= '0' && key.front() <= '9';
}

/// The key that an unknown one stands for, as far as can be told.
std::string meant_by(const std::string& key, const MappingSpec& spec) {
  return is_stray_time(key, spec) ? "keys" : nearest_word(key, known_words(spec));
}

void report_unknown(const Node& key, const MappingSpec& spec, std::string_view place, Findings& findings) {
  const std::vector<std::string> known = known_words(spec);
  const std::string otherwise = is_stray_time(key.text, spec)
                                    ? "; times stand under 'keys'"
                                    : fmt::format("; known are {}", fmt::join(known, ", "));
  findings.error(key.where, fmt::format("unknown key '{}'{}{}{}", key.text, place.empty() ? "" : " in ",
                                        place, findings.proposal(key.text, known, otherwise)));
}

}  // namespace

const Entry* Fields::find(std::string_view key) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry* entry) { return entry->key.text == key; });
  return found == entries_.end() ? nullptr : *found;
}

const Node* Fields::value(std::string_view key) const {
  const Entry* entry = find(key);
  return entry == nullptr ? nullptr : &entry->value;
}

bool Fields::lacks(std::string_view key) const {
  return find(key) == nullptr && std::find(meant_.begin(), meant_.end(), key) == meant_.end();
}

std::optional<Fields> read_fields(const Node& node, const MappingSpec& spec, std::string_view place,
                                  Findings& findings) {
  if (!is_mapping(node, place, spec.example, findings)) return std::nullopt;
  std::vector<const Entry*> entries;
  std::vector<std::string> meant;
  for (const Entry& entry : node.entries) {
    const std::string& name = entry.key.text;
    const KeySpec* known = find_spec(spec, name);
    if (known != nullptr && entry.value.kind != Node::Kind::null) {
      entries.push_back(&entry);
      continue;
    }
    meant.push_back(known == nullptr ? meant_by(name, spec) : name);
    if (known == nullptr) {
      report_unknown(entry.key, spec, place, findings);
    } else {
      findings.error(entry.key.where, fmt::format("'{}' has no value", name));
    }
  }
  return Fields(std::move(entries), std::move(meant));
}

const Node* require(const Fields& fields, std::string_view key, Mark where, std::string_view place,
                    Findings& findings) {
  if (fields.lacks(key)) findings.error(where, fmt::format("{} needs '{}'", place, key));
  return fields.value(key);
}

bool is_mapping(const Node& node, std::string_view place, std::string_view example, Findings& findings) {
  if (node.kind == Node::Kind::map) return true;
  findings.error(node.where, fmt::format("{} must be a mapping such as {}, not {}",
                                         place.empty() ? "a timeline" : place, example, describe(node)));
  return false;
}

std::vector<std::string> known_words(const MappingSpec& spec) {
  std::vector<std::string> words;
  for (const KeySpec& key : spec.keys) words.emplace_back(key.name);
  return words;
}

}  // namespace flexkey
