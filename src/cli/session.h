#pragma once

#include <vector>

#include "cli/load.h"
#include "cli/options.h"
#include "flexkey/animate/scene.h"
#include "flexkey/timeline/steps.h"

namespace flexkey::cli {

/// Which of a shot's outputs a command makes.
enum class Purpose { all, files, pictures };

/// Runs of a shot that a command solves together, ready to be solved.
struct Session {
  const ShotOptions& options;
  const ReadTimeline& timeline;
  std::size_t family = 0;
  LoadedShot loaded;        // without the outputs that are not made
  std::vector<Shot> runs;   // of the family, likewise
  std::vector<int> picked;  // frames that are written, increasing; empty: all
  std::vector<int> wanted;  // frames that are solved for: those, or all where a picture is to hold the clip
  Scene scene = {};         // that of all runs
  double load_seconds = 0;

  /// Steps that each run is solved for; see timeline/steps.h.
  int step_count() const { return steps_until(loaded.shot, wanted); }
};

/// Loads and binds a family of runs; the timeline outlives it. Throws as load_family and bind_loaded do.
Session open_session(const ReadTimeline& timeline, std::size_t family, const ShotOptions& options,
                     Purpose purpose);

/// Says what is to be noted of the shot.
void say_warnings(const Session& session);

/// Whether the files of a session have a frame.
bool is_picked(const Session& session, int frame);

}  // namespace flexkey::cli
