// Waves and noise against their closed forms.
#include "flexkey/timeline/sway.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "flexkey/timeline/sampling.h"
#include "timeline/parsing.h"

namespace flexkey {
namespace {

constexpr double pi = std::numbers::pi;

HandleMotion motion_at(const Handle& tip, double time) {
  return sample_motion(tip, Vec3::Zero(), time);
}

TEST(Wave, IsASineAlongItsDirection) {
  const Handle tip = parse_tip("    wave: {amplitude: 0.5, along: [0, 3, 4], frequency: 2, phase: 30deg}\n");
  for (const double t : {0.0, 0.1, 0.4, 7.3}) {
    const Vec3 expected = 0.5 * std::sin(4 * pi * t + pi / 6) * Vec3(0, 0.6, 0.8);
    EXPECT_LT((motion_at(tip, t).move - expected).norm(), 1e-12) << t;
  }
}

TEST(Wave, AboutAnAxisTurnsAfterTheKeyedTurn) {
  const Handle tip = parse_tip(
      "    rotate: {axis: x, keys: {0s: 90deg}}\n"
      "    wave: {amplitude: 90deg, axis: z}\n");
  EXPECT_LT((motion_at(tip, 0.25).apply(Vec3::UnitY(), Vec3::Zero()) - Vec3::UnitZ()).norm(), 1e-12)
      << "y to z by the key, and z is the wave's axis";
  EXPECT_LT((motion_at(tip, 0.25).apply(Vec3::UnitX(), Vec3::Zero()) - Vec3::UnitY()).norm(), 1e-12);
}

TEST(Wave, SeveralAddUpAndAddToKeys) {
  const Handle tip = parse_tip(
      "    move: {keys: {0s: [1, 0, 0]}}\n"
      "    wave: [{amplitude: 1, along: x}, {amplitude: 2, along: x, phase: 90deg}]\n");
  EXPECT_NEAR(motion_at(tip, 0).move.x(), 3, 1e-12);
  EXPECT_NEAR(motion_at(tip, 0.25).move.x(), 2, 1e-12);
}

TEST(Wave, AShareIsOneOfTheDiagonal) {
  const Handle tip = parse_tip("    wave: {amplitude: 2%, along: x}\n");
  EXPECT_TRUE(tip.waves.at(0).sway.amplitude.is_share);
  EXPECT_DOUBLE_EQ(tip.waves.at(0).sway.amplitude.value, 0.02);
}

TEST(Wave, ADelayShiftsIt) {
  const Handle now = parse_tip("    wave: {amplitude: 1, along: x, frequency: 0.7}\n");
  const Handle later = parse_tip("    wave: {amplitude: 1, along: x, frequency: 0.7}\n    delay: 0.3s\n");
  for (const double t : {0.3, 1.0, 2.2})
    EXPECT_NEAR(motion_at(later, t).move.x(), motion_at(now, t - 0.3).move.x(), 1e-12);
}

TEST(Noise, StartsAtRestStaysWithinItsAmplitudeAndIsSmooth) {
  const Handle tip = parse_tip("    noise: {amplitude: 3, along: y, frequency: 4, seed: 7}\n");
  const auto y = [&](double t) { return motion_at(tip, t).move.y(); };
  EXPECT_EQ(y(0), 0);
  double largest = 0;
  constexpr double h = 1e-3;
  for (double t = 0; t < 25; t += h) {
    largest = std::max(largest, std::abs(y(t)));
    EXPECT_LT(std::abs(y(t + h) - 2 * y(t) + y(t - h)), 3 * 40 * 16 * h * h)
        << "a second derivative without jumps";
  }
  EXPECT_LE(largest, 3);
  EXPECT_GT(largest, 1) << "and it moves";
}

TEST(Noise, TheSeedChoosesTheMotionAndNothingElseDoes) {
  const Noise a{{}, 1, 1}, again{{}, 1, 1}, b{{}, 1, 2};
  double difference = 0;
  for (double t = 0.5; t < 20; ++t) {
    EXPECT_EQ(noise_at(a, t), noise_at(again, t));
    difference = std::max(difference, std::abs(noise_at(a, t) - noise_at(b, t)));
  }
  EXPECT_GT(difference, 0.1);
}

TEST(Sway, WhatIsWrongIsSaidWithItsPlace) {
  EXPECT_EQ(
      errors_of(with_tip("    wave: {amplitude: 1}\n")),
      "shot.yaml:5:11: error: 'wave' of handle 'tip' needs 'along', to sway to and fro, or 'axis', to turn "
      "about");
  EXPECT_EQ(errors_of(with_tip("    wave: {amplitude: 1, along: x, axis: y}\n")),
            "shot.yaml:5:36: error: 'along' and 'axis' exclude each other in 'wave' of handle 'tip'");
  EXPECT_EQ(errors_of(with_tip("    wave: {amplitude: 1, axis: y}\n")),
            "shot.yaml:5:23: error: angle '1' needs its unit: 1deg or 1rad");
  EXPECT_EQ(errors_of(with_tip("    noise: {amplitude: 1, along: y, frequency: 0}\n")),
            "shot.yaml:5:48: error: frequency 0 is outside 0..1000000 swings a second, above 0");
  EXPECT_EQ(errors_of(with_tip("    noise: {amplitude: 1, along: y, seed: -1}\n")),
            "shot.yaml:5:43: error: seed -1 is below 0");
  EXPECT_EQ(
      errors_of(with_tip("    noise: {amplitud: 1, along: y}\n")),
      "shot.yaml:5:13: error: unknown key 'amplitud' in 'noise' of handle 'tip'; did you mean 'amplitude'?");
}

}  // namespace
}  // namespace flexkey
