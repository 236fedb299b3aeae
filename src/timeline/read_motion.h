#pragma once

#include <string_view>

#include "flexkey/timeline/scope.h"

namespace flexkey {

// Each reads one motion of a handle. place: "'move' of handle 'tip'".

Track<Vec3> read_move(const Node& node, std::string_view place, Scope& scope);
Track<Vec3> read_to(const Node& node, std::string_view place, Scope& scope);
/// Factors above 0; a number stands for three of them.
Track<Vec3> read_scale(const Node& node, std::string_view place, Scope& scope);
/// Angles about the track's axis, or keys {axis, angle}; those may turn by at most 180° from one to the next.
Track<AxisAngle> read_rotate(const Node& node, std::string_view place, Scope& scope);
Track<Curve> read_curve_track(const Node& node, std::string_view place, Scope& scope);

}  // namespace flexkey
