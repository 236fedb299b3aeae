#pragma once

#include <string_view>

#include "flexkey/timeline/motion.h"
#include "flexkey/timeline/scope.h"

namespace flexkey {

/// What `rotate` says: one of the two is empty.
struct Rotation {
  Track<AxisAngle> turns;
  EulerTrack euler;
};

/// Angles about the track's axis; keys {axis, angle}, which may turn by at most 180° from one to the next; or
/// Euler angles. place: "'rotate' of handle 'tip'".
Rotation read_rotate(const Node& node, std::string_view place, Scope& scope);

/// {axis, angle}. place: "a key of 'rotate' of handle 'tip'".
std::optional<AxisAngle> read_turn(const Node& node, std::string_view place, Scope& scope);

/// [x, y, z], deg or rad.
std::optional<Vec3> read_angles(const Node& node, Scope& scope);

}  // namespace flexkey
