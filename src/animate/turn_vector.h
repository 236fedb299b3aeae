#pragma once

#include <vector>

#include "flexkey/timeline/track.h"

namespace flexkey {

/// Between two turns, by their angle where they have one axis, so that half of two turns is one; else by
/// slerp.
AxisAngle blend(const AxisAngle& from, const AxisAngle& to, double share);

/// The rotation vector, world, radians, by which a product of turns changes, the first of them applied first:
/// of all vectors of the rotation the one that the turns' own changes of angle add up to, whole turns
/// counted. from, to: turn for turn the same; one that is missing in `from` is none.
Vec3 turn_vector(const std::vector<AxisAngle>& from, const std::vector<AxisAngle>& to);

}  // namespace flexkey
