#pragma once

#include <functional>
#include <span>
#include <vector>

#include "cli/progress.h"
#include "cli/report.h"
#include "cli/run_states.h"
#include "cli/session.h"
#include "flexkey/animate/animate.h"

namespace flexkey::cli {

/// Runs that are solved in one pass, by number: first .. first + count - 1.
struct Batch {
  std::size_t first = 0, count = 0;
};

/// All runs of a session, a few at a time: more would gain little and hold more in memory.
std::vector<Batch> batches_of(const Session& session);

/// What a command wants of the frames.
struct FrameWish {
  Keep keep = Keep::nothing;
  /// Hears each wanted frame of each run, in order.
  std::function<void(std::size_t run, const SolvedFrame&)> on_frame = {};
};

/// A run of the shot as far as it is solved.
struct RunFrames {
  Clip clip;  // of the picked frames; without frames unless they were to be kept
  RunReport report;
};

/// The frames of a batch, from the state as far as they are there, else solved now and kept there. They end
/// early where a signal was noted. The seconds of the reports have those of `wish` in them.
std::vector<RunFrames> frames_of(const Session& session, RunStates& states, const Batch& batch,
                                 const FrameWish& wish, Progress& progress);

}  // namespace flexkey::cli
