#include "flexkey/timeline/rotation.h"

#include <algorithm>
#include <cmath>

namespace flexkey {

bool same_axis(const AxisAngle& a, const AxisAngle& b) {
  return (a.axis - b.axis).norm() < 1e-12;
}

bool same_axis(const Track<AxisAngle>& track) {
  return std::all_of(track.begin(), track.end(),
                     [&](const Key<AxisAngle>& key) { return same_axis(key.value, track.front().value); });
}

Eigen::Vector4d quaternion_of(const AxisAngle& turn) {
  const Vec3 vector = std::sin(0.5 * turn.angle) * turn.axis;
  return {std::cos(0.5 * turn.angle), vector.x(), vector.y(), vector.z()};
}

AxisAngle axis_angle_of(const Eigen::Vector4d& quaternion) {
  const Vec3 vector = quaternion.tail<3>();
  const double sine = vector.norm();
  if (sine == 0) return {};
  return {vector / sine, 2 * std::atan2(sine, quaternion[0])};
}

double turn_between(const AxisAngle& a, const AxisAngle& b) {
  if (same_axis(a, b)) return std::abs(b.angle - a.angle);
  const Eigen::Vector4d p = quaternion_of(a), q = quaternion_of(b);
  return 4 * std::atan2((p - q).norm(), (p + q).norm());
}

Eigen::Vector4d slerp(const Eigen::Vector4d& a, const Eigen::Vector4d& b, double s) {
  const double angle = 2 * std::atan2((a - b).norm(), (a + b).norm());
  if (angle < 1e-9) return (a + s * (b - a)).normalized();
  return (std::sin((1 - s) * angle) * a + std::sin(s * angle) * b) / std::sin(angle);
}

}  // namespace flexkey
