#pragma once

#include <vector>

#include "cli/load.h"
#include "cli/options.h"
#include "flexkey/animate/scene.h"
#include "flexkey/timeline/steps.h"

namespace flexkey::cli {

/// Which of a shot's outputs a command makes.
enum class Purpose { all, files, pictures };

/// A shot that a command works on, ready to solve.
struct Session {
  const ShotOptions& options;
  LoadedShot loaded;        // without the outputs that are not made
  std::vector<Shot> runs;   // one, or one a value of the sweep
  std::vector<int> picked;  // frames that are written, increasing; empty: all
  std::vector<int> wanted;  // frames that are solved for: those, or all where a picture is to hold the clip
  Scene scene = {};         // that of all runs
  double load_seconds = 0;

  /// Steps that each run is solved for; see timeline/steps.h.
  int step_count() const { return steps_until(loaded.shot, wanted); }
};

/// Loads and binds the shot and says its warnings. Throws as load_shot and bind_loaded do.
Session open_session(const ShotOptions& options, Purpose purpose);

/// Whether the files of a session have a frame.
bool is_picked(const Session& session, int frame);

}  // namespace flexkey::cli
