#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "animate/shots.h"
#include "flexkey/animate/animate.h"

namespace flexkey::test {

/// A test with an empty folder of its own for a shot's state.
class StateFolder : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::remove_all(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  const std::filesystem::path& folder() const { return folder_; }

 private:
  const testing::TestInfo* info_ = testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      (std::string("flexkey_") + info_->test_suite_name() + "_" + info_->name());
};

/// How a solve is ended.
enum class Ending { asked, killed };  // with a checkpoint, or behind the last one

/// Solves a take on from its state, for this many frames at most; one that is killed leaves a checkpoint
/// after the first frame of them.
inline Clip solve_on(const Take& take, const Mesh& mesh, TakeState& state, int frames,
                     Ending ending = Ending::asked) {
  int solved = 0;
  AnimateHooks hooks;
  hooks.on_solved = [&](std::size_t, const SolvedStep& step) {
    state.add(step.report, step.positions);
    if (++solved == 1) state.save_checkpoint(step.waypoint);
  };
  hooks.on_end = [&](std::size_t, const Waypoint& waypoint) {
    if (ending == Ending::asked) state.save_checkpoint(waypoint);
  };
  hooks.stop = [&] { return solved >= frames; };
  const Take continued{take.shot, take.scene, &state};
  return std::move(animate(std::span(&continued, 1), mesh, {}, hooks).front());
}

/// Solves a shot by and by, each time in a new state object, until all of it is there.
inline Clip solve_in_parts(const Take& take, const Mesh& mesh, const std::filesystem::path& folder,
                           int frames, Ending ending = Ending::asked) {
  for (int turn = 0; turn <= take.shot.frame_count(); ++turn) {
    TakeState state(folder, take, "test");
    const Clip clip = solve_on(take, mesh, state, frames, ending);
    if (static_cast<int>(clip.frames.size()) == take.shot.frame_count()) return clip;
  }
  ADD_FAILURE() << "the solve did not come to its end";
  return {};
}

inline void expect_same(const Clip& found, const Clip& expected) {
  ASSERT_EQ(found.frames.size(), expected.frames.size());
  for (std::size_t k = 0; k < expected.frames.size(); ++k) {
    EXPECT_EQ(found.frames[k], expected.frames[k]) << "frame " << k;
    const FrameReport &a = found.reports[k], &b = expected.reports[k];
    EXPECT_EQ(std::tie(a.frame, a.lambda, a.solves, a.estimate, a.converged, a.slipped),
              std::tie(b.frame, b.lambda, b.solves, b.estimate, b.converged, b.slipped))
        << "frame " << k;
  }
}

}  // namespace flexkey::test
