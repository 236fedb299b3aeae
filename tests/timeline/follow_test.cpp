// Paths that a handle rides on, and Euler angles.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "flexkey/timeline/sampling.h"
#include "timeline/parsing.h"

namespace flexkey {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Follow, TakesThePivotAlongByArcLength) {
  const Handle tip = parse_tip(
      "    follow: {path: {polyline: [[0, 0, 0], [1, 0, 0], [1, 3, 0]]}, keys: {0s: 0%, 4s: 100%}}\n");
  const Vec3 pivot(5, 6, 7);
  const auto at = [&](double t) { return sample_motion(tip, pivot, t).apply(pivot, pivot); };
  EXPECT_LT((at(0) - Vec3(0, 0, 0)).norm(), 1e-9);
  EXPECT_LT((at(0.5) - Vec3(0.5, 0, 0)).norm(), 1e-9);
  EXPECT_LT((at(2) - Vec3(1, 1, 0)).norm(), 1e-9);
  EXPECT_LT((at(4) - Vec3(1, 3, 0)).norm(), 1e-9);
}

TEST(Follow, TheTangentTurnsTheHandle) {
  const Handle tip = parse_tip(
      "    follow: {path: {polyline: [[0, 0, 0], [1, 0, 0], [1, 1, 0]]}, keys: {0s: 0, 1s: 1}, orient: "
      "tangent}\n");
  const auto turned = [&](double t) -> Vec3 {
    return sample_motion(tip, Vec3::Zero(), t).turn() * Vec3::UnitX();
  };
  EXPECT_LT((turned(0) - Vec3::UnitX()).norm(), 1e-9);
  EXPECT_LT((turned(0.4) - Vec3::UnitX()).norm(), 1e-9);
  EXPECT_LT((turned(0.9) - Vec3::UnitY()).norm(), 1e-9);
}

TEST(Follow, OnAFlatCurveTheTangentDoesNotRoll) {
  const Handle tip = parse_tip(
      "    follow: {path: {bezier: [[0, 0, 0], [1, 2, 0], [3, -2, 0], [4, 0, 0]]}, keys: {0s: 0%, 1s: 100%}, "
      "orient: tangent}\n");
  for (const double t : {0.1, 0.5, 0.77, 1.0}) {
    const Eigen::Matrix3d R = sample_motion(tip, Vec3::Zero(), t).turn();
    EXPECT_LT((R * Vec3::UnitZ() - Vec3::UnitZ()).norm(), 1e-9) << t;
  }
}

TEST(Follow, WhatIsWrongIsSaidWithItsPlace) {
  EXPECT_EQ(errors_of(with_tip("    follow: {path: arc, keys: {0s: 0%}}\n")),
            "shot.yaml:5:20: error: unknown path 'arc'; such names are defined under 'paths'");
  EXPECT_EQ(errors_of(with_tip("    follow: {path: rest, keys: {0s: 0%}}\n")),
            "shot.yaml:5:20: error: 'follow' of handle 'tip' follows a path; 'rest' is none");
  EXPECT_EQ(errors_of(with_tip("    follow: {path: {polyline: [[0, 0, 0], [1, 0, 0]]}, keys: {0s: 120%}}\n")),
            "shot.yaml:5:67: error: 120% is outside 0..100% of the path");
  EXPECT_EQ(errors_of(with_tip("    move: {keys: {0s: [0, 0, 0]}}\n"
                               "    follow: {path: {polyline: [[0, 0, 0], [1, 0, 0]]}, keys: {0s: 0%}}\n")),
            "shot.yaml:6:5: error: 'move' and 'follow' exclude each other in handle 'tip'");
}

TEST(Euler, TurnsAboutTheFixedAxesInTheirOrder) {
  const auto turn = [](const std::string& order, double t) {
    const Handle tip = parse_tip("    rotate: {euler: " + order +
                                 ", keys: {0s: [0deg, 0deg, 0deg], 1s: [90deg, 0deg, 90deg]}}\n");
    return sample_motion(tip, Vec3::Zero(), t).turn();
  };
  const Eigen::Matrix3d x(Eigen::AngleAxisd(pi / 2, Vec3::UnitX())),
      z(Eigen::AngleAxisd(pi / 2, Vec3::UnitZ()));
  EXPECT_LT((turn("xyz", 1) - z * x).norm(), 1e-12) << "x first";
  EXPECT_LT((turn("zyx", 1) - x * z).norm(), 1e-12) << "z first";
  const Eigen::Matrix3d half_x(Eigen::AngleAxisd(pi / 4, Vec3::UnitX())),
      half_z(Eigen::AngleAxisd(pi / 4, Vec3::UnitZ()));
  EXPECT_LT((turn("xyz", 0.5) - half_z * half_x).norm(), 1e-12) << "the angles are interpolated";
}

TEST(Euler, WhatIsWrongIsSaidWithItsPlace) {
  EXPECT_EQ(errors_of(with_tip("    rotate: {euler: xxz, keys: {0s: [0deg, 0deg, 0deg]}}\n")),
            "shot.yaml:5:21: error: 'euler' is an order of the axes such as xyz, not 'xxz'");
  EXPECT_EQ(
      errors_of(with_tip("    rotate: {euler: xyz, keys: {0s: 5deg}}\n")),
      "shot.yaml:5:37: error: three angles [x, y, z] such as [0deg, 90deg, 0deg] belong here, not '5deg'");
  EXPECT_EQ(errors_of(with_tip("    rotate: {axis: x, euler: xyz, keys: {0s: [0deg, 0deg, 0deg]}}\n")),
            "shot.yaml:5:14: error: 'axis' and 'euler' exclude each other in 'rotate' of handle 'tip'");
}

}  // namespace
}  // namespace flexkey
