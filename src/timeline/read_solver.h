#pragma once

#include "flexkey/timeline/scope.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// The settings of a preset: `paper` is eq 7 and eq 8 with cotangent weights, two solves a frame.
SolverSettings preset_settings(SolverSettings::Preset preset);

/// `solver`: the preset first, whatever the order in the file, then the explicit keys.
SolverSettings read_solver(const Node& node, Scope& scope);

}  // namespace flexkey
