#pragma once

#include <vector>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/scope.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// `cache`, `frames` and `usd` of `output`: each a path, {path: …} or a list of these.
std::vector<CacheOutput> read_cache_outputs(const Fields& output, Scope& scope);

}  // namespace flexkey
