#pragma once

#include <optional>
#include <vector>

#include "flexkey/timeline/scope.h"

namespace flexkey {

/// Three numbers, [x, y, z].
std::optional<Vec3> read_vector(const Node& node, Scope& scope);

/// [x, y, z] in mesh units, or a name under `points`.
std::optional<Vec3> read_point(const Node& node, Scope& scope);

/// A list of points; nothing if any of them is wrong.
std::optional<std::vector<Vec3>> read_points(const Node& node, Scope& scope);

/// A unit vector: x, y, z, their negatives, or [x, y, z] of any length but 0.
std::optional<Vec3> read_axis(const Node& node, Scope& scope);

}  // namespace flexkey
