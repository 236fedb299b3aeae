#include "flexkey/timeline/read_selection.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/scalar.h"
#include "flexkey/timeline/selection_kinds.h"

namespace flexkey {
namespace {

constexpr int most_rings = 1000;

bool is_bound(const std::string& key) {
  return key == "above" || key == "below";
}
bool is_kind(const std::string& key) {
  return !is_bound(key) && key != "grow";
}

std::optional<std::vector<Selection>> read_selections(const KindNode& kind, Scope& scope) {
  if (kind.value.kind != Node::Kind::list || kind.value.items.empty()) {
    const std::string found = kind.value.kind == Node::Kind::list ? "an empty one" : describe(kind.value);
    scope.findings.error(kind.value.where,
                         fmt::format("{} takes a list of selections, not {}", kind.place, found));
    return std::nullopt;
  }
  std::vector<Selection> selections;
  for (const Node& item : kind.value.items) {
    if (std::optional<Selection> selection =
            read_selection(item, fmt::format("a selection in {}", kind.place), scope)) {
      selections.push_back(std::move(*selection));
    }
  }
  if (selections.size() < kind.value.items.size()) return std::nullopt;
  return selections;
}

MaybeKind read_any(const KindNode& kind, Scope& scope) {
  std::optional<std::vector<Selection>> of = read_selections(kind, scope);
  return of ? MaybeKind(SelectAny{std::move(*of)}) : std::nullopt;
}

MaybeKind read_all(const KindNode& kind, Scope& scope) {
  std::optional<std::vector<Selection>> of = read_selections(kind, scope);
  return of ? MaybeKind(SelectAll{std::move(*of)}) : std::nullopt;
}

MaybeKind read_not(const KindNode& kind, Scope& scope) {
  std::optional<Selection> of = read_selection(kind.value, kind.place, scope);
  return of ? MaybeKind(SelectNot{{std::move(*of)}}) : std::nullopt;
}

MaybeKind read_kind(const Entry& entry, const Fields& fields, Scope& scope) {
  const std::string& name = entry.key.text;
  const KindNode kind{entry.value, fields, fmt::format("'{}'", name)};
  if (name == "any") return read_any(kind, scope);
  if (name == "all") return read_all(kind, scope);
  if (name == "not") return read_not(kind, scope);
  return read_simple_kind(name, kind, scope);
}

/// The one entry that names the selection's kind.
const Entry* find_kind(const Node& node, const Fields& fields, std::string_view place, Scope& scope) {
  std::vector<const Entry*> kinds;
  for (const Entry* entry : fields.entries()) {
    if (is_kind(entry->key.text)) kinds.push_back(entry);
  }
  const bool means_none = std::none_of(node.entries.begin(), node.entries.end(),
                                       [](const Entry& entry) { return entry.key.text != "grow"; });
  if (means_none) {
    scope.findings.error(node.where,
                         fmt::format("{} needs a kind, such as axis, group, sphere or vertices", place));
  }
  if (kinds.size() > 1) {
    const std::string &first = kinds[0]->key.text, &second = kinds[1]->key.text;
    scope.findings.error(kinds[1]->key.where,
                         fmt::format("a selection has one kind; '{1}' stands beside '{0}': join them with "
                                     "all: [{{{0}: …}}, {{{1}: …}}] or any: […]",
                                     first, second));
  }
  return kinds.size() == 1 ? kinds[0] : nullptr;
}

void check_bounds(const Fields& fields, Scope& scope) {
  if (!fields.lacks("axis") || !fields.lacks("attribute")) return;
  for (const Entry* entry : fields.entries()) {
    const std::string& name = entry->key.text;
    if (is_bound(name))
      scope.findings.error(entry->key.where, fmt::format("'{}' needs 'axis' or 'attribute' beside it", name));
  }
}

int read_grow(const Fields& fields, Scope& scope) {
  const Node* node = fields.value("grow");
  if (node == nullptr) return 0;
  const std::optional<int> rings = read_whole(*node, scope);
  if (rings && (*rings < 0 || *rings > most_rings)) {
    scope.findings.error(node->where, fmt::format("grow {} is outside 0..{} rings", *rings, most_rings));
  }
  return rings.value_or(0);
}

}  // namespace

std::optional<Selection> read_selection(const Node& node, std::string_view place, Scope& scope) {
  const std::optional<Fields> fields = read_fields(node, selection_keys, place, scope.findings);
  if (!fields) return std::nullopt;
  check_bounds(*fields, scope);
  const int grow = read_grow(*fields, scope);
  const Entry* entry = find_kind(node, *fields, place, scope);
  if (entry == nullptr) return std::nullopt;
  MaybeKind kind = read_kind(*entry, *fields, scope);
  if (!kind) return std::nullopt;
  return Selection{std::move(*kind), grow, entry->value.where};
}

}  // namespace flexkey
