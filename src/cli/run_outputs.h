#pragma once

#include <string>
#include <vector>

#include "cli/cache_outputs.h"
#include "cli/session.h"
#include "cli/solve_runs.h"

namespace flexkey::cli {

/// Refuses, before hours of solving, what could not be written after. Throws UsageError where the shot names
/// no output, TimelineError for one that does not fit, OutputError for one that cannot be written now.
void require_outputs(const Session& session);

/// Whether an output needs all frames at once.
bool needs_clip(const Shot& shot);

/// What a run writes: some of it as the frames come, the rest when all are there.
class RunOutputs {
 public:
  /// Opens the files of all frames.
  RunOutputs(const Session& session, std::size_t run);

  void add(const SolvedFrame& frame);
  /// Solves the poses, writes the rest and adds both to the report; false, and nothing is written, where a
  /// signal came before. Throws OutputError.
  bool finish(RunFrames& frames);
  /// Seconds spent in `add` so far.
  double seconds() const { return caches_.seconds(); }
  /// What becomes of the outputs of a run that was stopped; a sentence each.
  std::vector<std::string> fates() const;

 private:
  void write_clip(RunFrames& frames, std::vector<PoseShape> poses);

  const Session& session_;
  const Shot& run_;
  RunCaches caches_;
  std::vector<HandleTrack> handles_;  // where the GLB has them
};

}  // namespace flexkey::cli
