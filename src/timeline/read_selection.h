#pragma once

#include <optional>
#include <string_view>

#include "flexkey/timeline/scope.h"

namespace flexkey {

/// A selection; nothing, and findings, if it is wrong. place: "'select' of handle 'tip'".
std::optional<Selection> read_selection(const Node& node, std::string_view place, Scope& scope);

}  // namespace flexkey
