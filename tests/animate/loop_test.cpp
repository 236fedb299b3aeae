// Cycles and ping-pong: which frames there are, and what they start from.
#include <gtest/gtest.h>

#include "animate/state_folder.h"
#include "flexkey/animate/laps.h"
#include "flexkey/timeline/steps.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

using test::expect_same;
using test::held_bar;
using test::shot_of;

const std::string swaying = held_bar +
                            "  tip:\n"
                            "    select: {axis: z, above: 100%}\n"
                            "    rotate: {axis: x, keys: {0s: 0deg, 0.5s: 70deg, 1s: 0deg}}\n"
                            "fps: 8\nlambda: 0.4\n";

class Loops : public test::StateFolder {
 protected:
  const Mesh bar_ = meshes::bar(2, 2, 8);
  const double diagonal_ = bounds_of(bar_.positions).diagonal();

  Clip solved(const std::string& text, const std::vector<int>& wanted = {}) const {
    const Shot shot = shot_of(text);
    return animate(shot, bar_, bind_shot(shot, bar_), wanted);
  }
};

TEST_F(Loops, PingPongPlaysTheSolvedFramesBackwards) {
  const Clip there = solved(swaying + "duration: 0.5s\n");
  const Clip clip = solved(swaying + "duration: 0.5s\nloop: ping-pong\n");
  ASSERT_EQ(clip.frames.size(), 9u);
  for (std::size_t k = 0; k < 9; ++k) {
    EXPECT_EQ(clip.frames[k], there.frames[k < 5 ? k : 8 - k]) << k;
    EXPECT_EQ(clip.reports[k].frame, static_cast<int>(k));
  }
  EXPECT_EQ(clip.frames.back(), clip.frames.front());
  EXPECT_GT((clip.frames[4] - clip.frames[0]).norm(), 0.1);
}

TEST_F(Loops, PingPongGivesSingleFramesOfTheWayBack) {
  const Clip clip = solved(swaying + "duration: 0.5s\nloop: ping-pong\n");
  const Clip some = solved(swaying + "duration: 0.5s\nloop: ping-pong\n", {1, 6});
  ASSERT_EQ(some.frames.size(), 2u);
  EXPECT_EQ(some.frames[0], clip.frames[1]);
  EXPECT_EQ(some.frames[1], clip.frames[6]);
  EXPECT_EQ(some.reports[1].frame, 6);
}

TEST_F(Loops, ACycleKeepsTheSecondLap) {
  const Clip two_laps = solved(held_bar +
                               "  tip:\n"
                               "    select: {axis: z, above: 100%}\n"
                               "    rotate: {axis: x, keys: {0s: 0deg, 0.5s: 70deg, 1s: 0deg}}\n"
                               "    repeat: 2\n"
                               "fps: 8\nlambda: 0.4\n");
  const Clip clip = solved(swaying + "loop: cycle\n");
  ASSERT_EQ(clip.frames.size(), 8u);
  ASSERT_EQ(two_laps.frames.size(), 17u);
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_EQ(clip.frames[k], two_laps.frames[8 + k]) << k;
    EXPECT_EQ(clip.reports[k].frame, static_cast<int>(k));
  }
  const double gap = (two_laps.frames[16] - two_laps.frames[8]).rowwise().norm().maxCoeff() / diagonal_;
  ASSERT_TRUE(clip.gap);
  EXPECT_DOUBLE_EQ(*clip.gap, gap);
  EXPECT_LT(*clip.gap, 2e-3);
}

TEST_F(Loops, KeysThatDoNotComeRoundAreAGap) {
  const Clip clip =
      solved(held_bar +
             "  tip: {select: {axis: z, above: 100%}, move: {keys: {0s: [0, 0, 0], 1s: [1, 0, 0]}}}\n"
             "fps: 8\nlambda: 0.4\nloop: cycle\n");
  ASSERT_TRUE(clip.gap);
  EXPECT_NEAR(*clip.gap, 1 / diagonal_, 1e-6);
}

/// A bar that turns as a whole is at 360° where it was at 0°, and has not to turn back.
TEST_F(Loops, AWholeTurnGoesOnIntoTheNext) {
  const std::string text =
      "mesh: bar.obj\nhandles:\n"
      "  base: {select: {axis: z, below: 0%}, pivot: [0, 0, 0], rotate: {axis: z, keys: {0s: 0deg, 1s: "
      "360deg}}}\n"
      "fps: 16\nlambda: 1\nloop: cycle\n";
  const Shot shot = shot_of(text);
  const Scene scene = bind_shot(shot, bar_);
  EXPECT_TRUE(turns_to_unwind({shot, scene}, 15).empty());
  const std::vector<std::vector<double>> turns = turns_to_unwind({shot, scene}, 16);
  ASSERT_EQ(turns.size(), 1u);
  EXPECT_DOUBLE_EQ(turns[0][0], 2 * std::numbers::pi);
  const Clip clip = animate(shot, bar_, scene);
  EXPECT_LT(clip.gap.value_or(1), 1e-6);
  for (const FrameReport& report : clip.reports) EXPECT_LE(report.solves, 2) << report.frame;
}

/// A bar that is twisted by a turn a lap never comes round, and is not untwisted in a frame.
TEST_F(Loops, ATwistThatGoesOnIsAGap) {
  const Mesh bar = meshes::bar(2, 2, 40);
  const Shot shot =
      shot_of(held_bar +
              "  tip: {select: {axis: z, above: 100%}, rotate: {axis: z, keys: {0s: 0deg, 1s: 360deg}}}\n"
              "fps: 16\nlambda: 0.8\nloop: cycle\n");
  const Clip clip = animate(shot, bar, bind_shot(shot, bar));
  EXPECT_GT(clip.gap.value_or(0), 0.01);
}

TEST_F(Loops, ThatStopGoOnToTheSameBytes) {
  for (const std::string loop : {"cycle", "ping-pong"}) {
    SCOPED_TRACE(loop);
    const Shot shot = shot_of(swaying + "loop: " + loop + "\n");
    const Scene scene = bind_shot(shot, bar_);
    const Clip whole = animate(shot, bar_, scene);
    std::filesystem::remove_all(folder());
    Clip clip;
    for (int turn = 0; turn < step_count(shot) && clip.frames.size() < whole.frames.size(); ++turn) {
      TakeState state(folder(), {shot, scene}, "test");
      clip = test::solve_on({shot, scene}, bar_, state, 3);
    }
    expect_same(clip, whole);
    EXPECT_EQ(clip.gap, whole.gap);
    TakeState state(folder(), {shot, scene}, "test");
    EXPECT_TRUE(state.is_complete());
    expect_same(test::solve_on({shot, scene}, bar_, state, 1), whole);  // all from the state
  }
}

TEST_F(Loops, AStateOfOneKindDoesNotServeAnotherBeyondItsFirstLap) {
  const Shot plain = shot_of(swaying), cycle = shot_of(swaying + "loop: cycle\n");
  const Scene scene = bind_shot(plain, bar_);
  TakeState state(folder(), {plain, scene}, "test");
  test::solve_on({plain, scene}, bar_, state, 9);
  EXPECT_EQ(TakeState(folder(), {cycle, scene}, "test").frames(), 8);
}

}  // namespace
}  // namespace flexkey
