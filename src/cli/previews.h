#pragma once

#include <memory>
#include <vector>

#include "cli/report.h"
#include "cli/run_states.h"
#include "cli/session.h"
#include "flexkey/animate/clip.h"

namespace flexkey::cli {

/// Whether this build can make pictures.
bool draws_previews();

/// Loads now what the first picture would load: 0.2 s. Throws OutputError where it cannot be loaded.
void preload_previews();

/// Throws TimelineError for pictures that this build cannot make, or that would replace an input or another
/// output.
void check_previews(const LoadedShot& loaded, const ShotOptions& options, const std::vector<Shot>& runs);

/// Throws OutputError for what cannot be written now. Checked before hours of solving.
void probe_previews(const ShotOptions& options, const std::vector<Shot>& runs);

/// The pictures of all runs of a shot. Where the camera is known before the solve, a frame is drawn while
/// the next is solved. Else the frames wait in the state, or on disk where none is kept, until the last is
/// there, since all of them are to be in the picture: the same pixels whichever frames are asked for.
class Previews {
 public:
  /// Refers to both. Throws InputError for a mesh that cannot be drawn.
  Previews(const Session& session, const RunStates& states);
  ~Previews();

  /// Takes a wanted frame of a run.
  void add(std::size_t run, const SolvedFrame& frame);
  /// Draws what is left and makes GIFs and sheets of the pictures, unless a signal is noted.
  std::vector<WrittenPreview> finish();
  /// Whole lines.
  std::vector<std::string> warnings() const;
  /// What there is of the pictures after a signal, those under way included; a sentence each.
  std::vector<std::string> fates() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace flexkey::cli
