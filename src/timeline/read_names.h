#pragma once

#include <optional>
#include <string_view>

#include "flexkey/timeline/scope.h"

namespace flexkey {

/// `times`: later ones may build on earlier ones.
void read_times(const Node& node, Scope& scope);
/// `points`: name to [x, y, z].
void read_named_points(const Node& node, Scope& scope);
/// `paths`: name to a curve, or to a list of points, which are joined by straight lines.
void read_paths(const Node& node, Scope& scope);

/// `rest`, {polyline | catmull-rom | bezier: points}, or a name under `paths`.
std::optional<Curve> read_curve(const Node& node, std::string_view place, Scope& scope);

}  // namespace flexkey
