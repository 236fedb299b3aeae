// The frames of a shot and the steps that are solved for them.
#include "flexkey/timeline/steps.h"

#include <gtest/gtest.h>

#include "timeline/parsing.h"

namespace flexkey {
namespace {

/// A shot of half a second, 4 frames a second.
Shot looped(const std::string& loop) {
  return parse(with_base("fps: 4\nduration: 0.5s\nloop: " + loop + "\n"));
}

TEST(Steps, AreTheFramesOfAShotThatIsNotLooped) {
  const Shot shot = looped("none");
  EXPECT_EQ(shot.frame_count(), 3);
  EXPECT_EQ(step_count(shot), 3);
  EXPECT_EQ(step_of(shot, 2), 2);
  EXPECT_EQ(frame_of(shot, 2), 2);
  EXPECT_EQ(time_of_frame(shot, 2), 0.5);
  EXPECT_EQ(steps_until(shot, {0, 1}), 2);
}

TEST(Steps, OfACycleAreTwoLapsAndItsEnd) {
  const Shot shot = looped("cycle");
  EXPECT_EQ(shot.frame_count(), 2);
  EXPECT_EQ(step_count(shot), 5);
  const double times[] = {0, 0.25, 0, 0.25, 0.5};
  for (int step = 0; step < 5; ++step) EXPECT_EQ(time_of_step(shot, step), times[step]) << step;
  EXPECT_EQ(frame_of(shot, 1), std::nullopt);
  EXPECT_EQ(frame_of(shot, 2), 0);
  EXPECT_EQ(frame_of(shot, 4), std::nullopt);
  EXPECT_EQ(step_of(shot, 1), 3);
  EXPECT_EQ(steps_until(shot, {}), 5);
  EXPECT_EQ(steps_until(shot, {1}), 4);
  EXPECT_EQ(played_duration(shot), 0.5);
}

TEST(Steps, OfPingPongAreItsWayThere) {
  const Shot shot = looped("ping-pong");
  EXPECT_EQ(shot.frame_count(), 5);
  EXPECT_EQ(step_count(shot), 3);
  const int steps[] = {0, 1, 2, 1, 0};
  for (int frame = 0; frame < 5; ++frame) EXPECT_EQ(step_of(shot, frame), steps[frame]) << frame;
  EXPECT_EQ(time_of_frame(shot, 4), 0);
  EXPECT_EQ(steps_until(shot, {4}), 1);
  EXPECT_EQ(steps_shown(shot, {1, 3, 4}), (std::vector<int>{0, 1}));
  EXPECT_EQ(played_duration(shot), 1);
}

TEST(Steps, ACycleLastsAFrameAtLeast) {
  EXPECT_EQ(errors_of(with_base("loop: cycle\n")),
            "shot.yaml:4:7: error: a cycle lasts a frame at least, and the shot 0s");
}

TEST(Steps, ACycleOfAPartOfAFrameIsShorter) {
  EXPECT_EQ(warnings_of(with_base("fps: 4\nduration: 0.6s\nloop: cycle\n")),
            (std::vector<std::string>{
                "shot.yaml:6:7: warning: the cycle's 0.6s are 2.4 frames; it comes round after 2"}));
}

}  // namespace
}  // namespace flexkey
