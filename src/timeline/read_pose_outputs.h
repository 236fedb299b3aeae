#pragma once

#include <vector>

#include "flexkey/timeline/scope.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// Which poses become morph targets: `all`, or their names, each once.
std::vector<PoseOutput> read_pose_outputs(const Node& node, Scope& scope);

}  // namespace flexkey
