#pragma once

#include "flexkey/deform/course.h"
#include "flexkey/deform/weights.h"

namespace flexkey {

/// Whether the surface has lost a turn that its handles made: neighbouring cells whose frames of rotations
/// add up to vectors far more than half a turn apart, although R_i and R_j are near one another, while two
/// handles are turned against each other by half a turn or more. It ends when the handles have turned back.
bool has_slipped(const Cells& cells, const Course& course);

}  // namespace flexkey
