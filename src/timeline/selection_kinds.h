#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/scope.h"

namespace flexkey {

/// What a kind of selection is read from: its key's value, and the mapping that it stands in.
struct KindNode {
  const Node& value;
  const Fields& fields;
  std::string place;  // "'sphere'"
};

using MaybeKind = std::optional<decltype(Selection::kind)>;

/// A kind that holds no other selections, by its key's name.
MaybeKind read_simple_kind(std::string_view name, const KindNode& kind, Scope& scope);

}  // namespace flexkey
