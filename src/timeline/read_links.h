#pragma once

#include <vector>

#include "flexkey/timeline/scope.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// What a handle says of other handles, by name; nothing where it does not.
struct HandleLinks {
  const Node* parent = nullptr;
  const Node* mirror_of = nullptr;
};

/// Finds the handles that are named, and refuses those that come back to themselves. handles, links: equally
/// many.
void link_handles(const std::vector<HandleLinks>& links, std::vector<Handle>& handles, Scope& scope);

}  // namespace flexkey
