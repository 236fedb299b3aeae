#pragma once

#include <string>
#include <vector>

#include "cli/load.h"
#include "cli/report.h"
#include "flexkey/cache/frame_sink.h"

namespace flexkey::cli {

/// What the runs' caches, sequences and USD files would meet: throws TimelineError for one that would replace
/// an input or another output, and for a PC2 of frames that are not evenly spaced.
void check_caches(const LoadedShot& loaded, const ShotOptions& options, const std::vector<Shot>& runs);

/// Throws OutputError for what cannot be written now. Checked before hours of solving.
void probe_caches(const LoadedShot& loaded, const ShotOptions& options, const std::vector<Shot>& runs);

/// One run's caches on their way, which take its frames as they are solved.
class RunCaches {
 public:
  /// Opens the files of all frames.
  RunCaches(const LoadedShot& loaded, const ShotOptions& options, const Shot& run);
  void add(const SolvedFrame& frame);
  /// Gives the files their names, after the last frame.
  std::vector<WrittenCache> finish();
  /// Seconds spent here so far.
  double seconds() const;
  /// What becomes of the caches of a run that was stopped after this many frames, such as "'bar.pc2' was not
  /// written"; a sentence each.
  std::vector<std::string> fates() const;

 private:
  struct Open {
    WrittenCache report;
    bool is_sequence;
    FrameSink sink;
  };
  std::vector<Open> caches_;
};

}  // namespace flexkey::cli
