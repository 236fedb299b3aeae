#pragma once

#include <Eigen/Geometry>

#include "flexkey/timeline/shot.h"

namespace flexkey {

/// A handle's own motion at one time: x -> pivot + R S (x - pivot) + move, all in world axes.
struct HandleMotion {
  Vec3 scale{1, 1, 1};
  AxisAngle rotation;              // the angle as keyed, many turns included
  std::vector<AxisAngle> further;  // turns that come after it, in this order; R is the product of all
  Vec3 move{0, 0, 0};
  Eigen::Matrix3d turn() const;  // R
  Vec3 apply(const Vec3& x, const Vec3& pivot) const;
};

/// λ at a time, clamped to [0, 1].
double sample_lambda(const Track<double>& lambda, double time);

/// Whether a handle holds at a time.
bool is_active(const Handle& handle, double time);

/// Whether there is a time at which both hold.
bool active_together(const Handle& a, const Handle& b);

/// How firmly: 0 while it does not, 1 while it does, and in between within `fade` of an end, smoothstep.
double sample_grip(const Handle& handle, double time);

/// The motion of a handle about `pivot` (for `to` and `follow`) at a time. Exact at the keys. The handle has
/// no `curve` and no `mirror`, and its waves' amplitudes are lengths.
HandleMotion sample_motion(const Handle& handle, const Vec3& pivot, double time);

/// The motion as a mirror across a plane of this unit normal, one of the world axes, shows it.
HandleMotion mirrored(const HandleMotion& motion, const Vec3& normal);

/// Where the vertices of a `curve` handle lie at a time. chain: #n x 3, its path vertices at rest, in order.
/// Vertex i stays at the same share of arc length on every curve; between keys, points blend.
Positions sample_curve(const Track<Curve>& track, const Positions& chain, double time);

/// Points at shares (0..1) of a curve's arc length, one a row.
Positions points_at(const Curve& curve, const Positions& chain, const Eigen::VectorXd& shares);

}  // namespace flexkey
