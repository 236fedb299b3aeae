#pragma once

#include <optional>
#include <vector>

#include "flexkey/timeline/scope.h"

namespace flexkey {

/// Vertex indices from 0 and ranges of them: [0, 12-40], 7, or "0,12-40".
std::optional<std::vector<IndexRange>> read_index_ranges(const Node& node, Scope& scope);

}  // namespace flexkey
