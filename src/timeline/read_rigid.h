#pragma once

#include <vector>

#include "flexkey/timeline/scope.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// `rigid`: name to selection.
std::vector<RigidSelection> read_rigid(const Node& node, Scope& scope);

}  // namespace flexkey
