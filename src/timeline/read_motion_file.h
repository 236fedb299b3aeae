#pragma once

#include <string_view>

#include "flexkey/timeline/scope.h"

namespace flexkey {

/// {from: rig.glb#Node} or {csv: table.csv}. place: "'motion' of handle 'tip'".
MotionTracks read_motion_file(const Node& node, std::string_view place, Scope& scope);

}  // namespace flexkey
