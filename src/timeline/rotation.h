#pragma once

#include <Eigen/Geometry>

#include "flexkey/timeline/track.h"

namespace flexkey {

/// Whether two turns are about one axis, so that their angles alone tell them apart.
bool same_axis(const AxisAngle& a, const AxisAngle& b);
bool same_axis(const Track<AxisAngle>& track);

/// (w, x, y, z) with the sign that the keyed angle gives: cos(θ/2), sin(θ/2) n. Turns of θ and θ + 2π differ
/// in sign.
Eigen::Vector4d quaternion_of(const AxisAngle& turn);
AxisAngle axis_angle_of(const Eigen::Vector4d& quaternion);

/// The turn from `a` to `b` as keyed, radians: about one axis the difference of the angles, else the angle
/// between the quaternions with their signs, in 0..2π.
double turn_between(const AxisAngle& a, const AxisAngle& b);

/// The great arc from `a` to `b` at share s (Shoemake, "Animating rotation with quaternion curves"); the
/// signs are kept, so that the turn is the keyed one, up to π.
Eigen::Vector4d slerp(const Eigen::Vector4d& a, const Eigen::Vector4d& b, double s);

}  // namespace flexkey
