#pragma once

#include <string_view>
#include <vector>

#include "flexkey/timeline/scope.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// The poses under `poses`, into the scope.
void read_poses(const Node& node, Scope& scope);

/// Where the poses that `pose` names have a handle. place: "'pose' of handle 'tip'".
MotionTracks read_pose_track(const Node& node, std::string_view handle, std::string_view place, Scope& scope);

/// Refuses poses of handles that are not there.
void check_posed_handles(const std::vector<Handle>& handles, Scope& scope);

}  // namespace flexkey
