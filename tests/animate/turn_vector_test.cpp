#include "flexkey/animate/turn_vector.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

namespace flexkey {
namespace {

constexpr double pi = std::numbers::pi;

Eigen::Matrix3d product(const std::vector<AxisAngle>& turns) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  for (const AxisAngle& turn : turns) R = Eigen::AngleAxisd(turn.angle, turn.axis) * R;
  return R;
}

TEST(TurnVector, IsTheRotationFromOneProductToTheOther) {
  const std::vector<AxisAngle> from{{Vec3::UnitX(), 0.3}, {Vec3::UnitY(), 1.2}, {Vec3(1, 2, 2) / 3, -0.4}};
  std::vector<AxisAngle> to = from;
  to[0].angle = 0.5, to[1].angle = 0.9, to[2].angle = 0.1;
  const Vec3 v = turn_vector(from, to);
  const Eigen::Matrix3d change(Eigen::AngleAxisd(v.norm(), v.normalized()));
  EXPECT_LT((change * product(from) - product(to)).norm(), 1e-12);
}

TEST(TurnVector, CountsWholeTurns) {
  const std::vector<AxisAngle> from{{Vec3::UnitZ(), 0}, {Vec3::UnitX(), 0}};
  const std::vector<AxisAngle> to{{Vec3::UnitZ(), 6 * pi + 0.1}, {Vec3::UnitX(), 0.2}};
  EXPECT_LT((turn_vector(from, to) - Vec3(0.2, 0, 6 * pi + 0.1)).norm(), 1e-12);
  EXPECT_NEAR(turn_vector({}, {{Vec3::UnitY(), 4 * pi}, {Vec3::UnitY(), 2 * pi}}).y(), 6 * pi, 1e-12);
}

TEST(TurnVector, OfOneTurnIsItsChangeToTheBit) {
  const Vec3 v = turn_vector({{Vec3::UnitZ(), 0.25}}, {{Vec3::UnitZ(), 0.75}});
  EXPECT_EQ(v, Vec3(0, 0, 0.5));
}

}  // namespace
}  // namespace flexkey
