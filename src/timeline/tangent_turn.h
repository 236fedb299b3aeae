#pragma once

#include "flexkey/timeline/curve.h"

namespace flexkey {

/// How the tangent of a curve turns from one share (0..1) of its length to another, without rolling about
/// itself: parallel transport, in small steps (Bishop, "There is more than one way to frame a curve", 1975).
AxisAngle tangent_turn(const MeasuredCurve& curve, double from, double to);

}  // namespace flexkey
