#pragma once

#include <vector>

#include "flexkey/timeline/scope.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// What `output` names.
struct Outputs {
  GltfOutput gltf;
  std::vector<CacheOutput> caches;
};

/// `output`: the path of a GLB, or {gltf, cache, frames, usd}. Without `gltf` that has no path.
Outputs read_output(const Node& node, Scope& scope);

}  // namespace flexkey
