#include "flexkey/timeline/rotation.h"

#include <gtest/gtest.h>

#include <numbers>

namespace flexkey {
namespace {

constexpr double pi = std::numbers::pi;
const AxisAngle about_x{Vec3::UnitX(), pi / 2};
const AxisAngle about_z{Vec3::UnitZ(), pi / 2};

TEST(Rotation, QuaternionsAndBack) {
  const AxisAngle turn{Vec3(1, 2, 2) / 3, 2.5};
  const AxisAngle back = axis_angle_of(quaternion_of(turn));
  EXPECT_NEAR(back.angle, turn.angle, 1e-14);
  EXPECT_TRUE(back.axis.isApprox(turn.axis, 1e-14));
  EXPECT_EQ(axis_angle_of(quaternion_of({Vec3::UnitX(), 0})).angle, 0);
}

TEST(Rotation, TurnBetween) {
  EXPECT_NEAR(turn_between({Vec3::UnitZ(), 0}, {Vec3::UnitZ(), 4 * pi}), 4 * pi, 1e-14)
      << "one axis: as keyed";
  EXPECT_NEAR(turn_between({Vec3::UnitZ(), 0}, {Vec3::UnitX(), 1.5 * pi}), 1.5 * pi, 1e-12)
      << "not the short way";
  EXPECT_NEAR(turn_between(about_x, about_z), 2 * pi / 3, 1e-12) << "a third of a turn about (1, -1, 1)";
  EXPECT_NEAR(turn_between(about_z, {-Vec3::UnitZ(), pi / 2}), pi, 1e-12);
}

TEST(Rotation, SlerpTurnsEvenly) {
  const Eigen::Vector4d a = quaternion_of(about_x), b = quaternion_of(about_z);
  EXPECT_TRUE(slerp(a, b, 0).isApprox(a, 1e-14));
  EXPECT_TRUE(slerp(a, b, 1).isApprox(b, 1e-14));
  const double whole = turn_between(about_x, about_z);
  for (const double s : {0.1, 0.25, 0.5, 0.9}) {
    const Eigen::Vector4d q = slerp(a, b, s);
    EXPECT_NEAR(q.norm(), 1, 1e-14);
    EXPECT_NEAR(turn_between(about_x, axis_angle_of(q)), s * whole, 1e-12);
  }
}

TEST(Rotation, SlerpOfEqualOrNearQuaternions) {
  const Eigen::Vector4d a = quaternion_of(about_x);
  EXPECT_TRUE(slerp(a, a, 0.5).isApprox(a, 1e-14));
  const Eigen::Vector4d near = quaternion_of({Vec3::UnitX(), pi / 2 + 1e-10});
  EXPECT_TRUE(slerp(a, near, 0.5).allFinite());
}

}  // namespace
}  // namespace flexkey
