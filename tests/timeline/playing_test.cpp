// repeat and delay.
#include <gtest/gtest.h>

#include "flexkey/timeline/sampling.h"
#include "timeline/parsing.h"

namespace flexkey {
namespace {

const std::string two_tracks =
    "    move: {keys: {1s: [0, 0, 0], 2s: [1, 0, 0]}}\n"
    "    rotate: {axis: z, keys: {1.5s: 10deg, 3s: 40deg}}\n";

TEST(Repeat, PlaysTheKeyedTimeAgain) {
  const Handle once = parse_tip(two_tracks), thrice = parse_tip(two_tracks + "    repeat: 3\n");
  for (const double t : {0.0, 1.0, 1.3, 1.5, 2.0, 2.7, 2.999})
    for (const int n : {0, 1, 2}) {
      if (n > 0 && t < 1) continue;
      const HandleMotion a = sample_motion(once, Vec3::Zero(), t);
      const HandleMotion b = sample_motion(thrice, Vec3::Zero(), t + 2 * n);
      EXPECT_NEAR(a.move.x(), b.move.x(), 1e-12) << t << ", time " << n;
      EXPECT_NEAR(a.rotation.angle, b.rotation.angle, 1e-12) << t << ", time " << n;
    }
  EXPECT_EQ(sample_motion(thrice, Vec3::Zero(), 7).move.x(), 1) << "the last time holds its end";
  EXPECT_EQ(sample_motion(thrice, Vec3::Zero(), 5).move.x(), 0) << "a time ends where the next begins";
}

TEST(Repeat, MakesTheShotLast) {
  EXPECT_EQ(parse(with_tip(two_tracks)).duration, 3);
  EXPECT_EQ(parse(with_tip(two_tracks + "    repeat: 3\n")).duration, 7);
  EXPECT_EQ(parse(with_tip(two_tracks + "    repeat: 3\n    delay: 0.5s\n")).duration, 7.5);
}

TEST(Delay, ShiftsEveryKeyToAFrame) {
  const Handle tip =
      parse_tip("    move: {keys: {8f: [0, 0, 0], 16f: [1, 0, 0]}, ease: hold}\n    delay: 7f\n");
  EXPECT_EQ(tip.move.at(1).time, 23.0 / 24);
  EXPECT_EQ(sample_motion(tip, Vec3::Zero(), 22.0 / 24).move.x(), 0);
  EXPECT_EQ(sample_motion(tip, Vec3::Zero(), 23.0 / 24).move.x(), 1);
}

TEST(Playing, WhatIsWrongIsSaidWithItsPlace) {
  EXPECT_EQ(errors_of(with_tip(two_tracks + "    repeat: 0\n")),
            "shot.yaml:7:13: error: repeat 0 is outside 1..100000 times");
  EXPECT_EQ(
      errors_of(with_tip(two_tracks + "    repeat: 99999\n")),
      "shot.yaml:7:13: error: repeated 99999 times, handle 'tip' would move for 4899951 frames; 1000000 are "
      "the most");
  EXPECT_EQ(errors_of(with_tip("    move: {keys: {1s: [0, 0, 0]}}\n    repeat: 2\n")),
            "shot.yaml:6:13: error: handle 'tip' repeats no time: it has no two keys");
  EXPECT_EQ(errors_of(with_tip("    delay: -1s\n")),
            "shot.yaml:5:12: error: time -1s lies before the start, 0s");
}

}  // namespace
}  // namespace flexkey
