#pragma once

#include <vector>

#include "cli/load.h"
#include "cli/options.h"
#include "flexkey/animate/scene.h"

namespace flexkey::cli {

/// A shot that a command works on, ready to solve.
struct Session {
  const ShotOptions& options;
  LoadedShot loaded;
  std::vector<Shot> runs;   // one, or one a value of the sweep
  std::vector<int> wanted;  // frames, increasing; empty: all
  Scene scene = {};         // that of all runs
  double load_seconds = 0;

  /// Frames that each run is solved for.
  int frame_count() const { return wanted.empty() ? loaded.shot.frame_count() : wanted.back() + 1; }
};

/// Loads and binds the shot and says its warnings. Throws as load_shot and bind_loaded do.
Session open_session(const ShotOptions& options);

}  // namespace flexkey::cli
