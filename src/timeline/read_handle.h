#pragma once

#include <optional>
#include <vector>

#include "flexkey/timeline/scope.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// `handles`: name to handle, in the file's order. Handles that are wrong are left out.
std::vector<Handle> read_handles(const Node& node, Scope& scope);

}  // namespace flexkey
