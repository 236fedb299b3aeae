#pragma once

#include <string_view>

#include "flexkey/timeline/motion.h"
#include "flexkey/timeline/scope.h"

namespace flexkey {

// Each reads one motion of a handle. place: "'move' of handle 'tip'".

Track<Vec3> read_move(const Node& node, std::string_view place, Scope& scope);
Track<Vec3> read_to(const Node& node, std::string_view place, Scope& scope);
/// Factors above 0; a number stands for three of them.
Track<Vec3> read_scale(const Node& node, std::string_view place, Scope& scope);
Track<Curve> read_curve_track(const Node& node, std::string_view place, Scope& scope);
std::optional<Follow> read_follow(const Node& node, std::string_view place, Scope& scope);

/// Factors as in `scale`.
std::optional<Vec3> read_factors(const Node& node, Scope& scope);

}  // namespace flexkey
