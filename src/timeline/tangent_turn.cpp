#include "flexkey/timeline/tangent_turn.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace flexkey {
namespace {

/// Not unit; 0 where the curve has no length.
Vec3 tangent(const MeasuredCurve& curve, double share) {
  constexpr double h = 1e-5;  // of the length to both sides
  return curve.at(share + h) - curve.at(share - h);
}

}  // namespace

AxisAngle tangent_turn(const MeasuredCurve& curve, double from, double to) {
  constexpr double step = 1.0 / 512;  // of the length
  from = std::clamp(from, 0.0, 1.0);
  to = std::clamp(to, 0.0, 1.0);
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / step)));
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  Vec3 before = tangent(curve, from);
  for (int k = 1; k <= steps; ++k) {
    const Vec3 after = tangent(curve, from + (to - from) * k / steps);
    if (before.isZero(0) || after.isZero(0)) continue;
    turn = (Eigen::Quaterniond::FromTwoVectors(before, after) * turn).normalized();
    before = after;
  }
  const Eigen::AngleAxisd total(turn);
  return {total.axis(), total.angle()};
}

}  // namespace flexkey
