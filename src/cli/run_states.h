#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/session.h"
#include "cli/state_lock.h"
#include "flexkey/animate/animate.h"
#include "flexkey/animate/take_state.h"

namespace flexkey::cli {

/// What the state is to a command.
enum class StateUse {
  helps,   // what cannot be kept is a warning
  needed,  // what cannot be kept is an error
  trusted  // nothing is solved
};

/// The state of a shot's runs, in OUT-DIR/.flexkey/SHOT/ or, of a sweep, in a folder a run there, each under
/// its lock: what is solved of them.
class RunStates {
 public:
  /// Says why what is there does not serve, or that it is gone on with. The session outlives it. Throws
  /// OutputError where a state is `needed` and cannot be kept, or another flexkey is at it; UsageError where
  /// it is `trusted` and missing, stale or not all of what is wanted.
  RunStates(const Session& session, StateUse use);

  const std::filesystem::path& folder() const { return folder_; }
  /// What is solved of a run; null: nothing is kept.
  const TakeState* of(std::size_t run) const { return states_.empty() ? nullptr : states_[run].get(); }

  /// What is, or will be, solved of a run, with every wanted frame in the end; null: it is not kept.
  const TakeState* kept(std::size_t run) const;

  /// Keeps a frame that was solved now, and a checkpoint where one is due. Throws OutputError where the state
  /// is `needed`; else, with a warning, the run's state is given up and its room left to the outputs.
  void add(std::size_t run, const SolvedStep& step);
  /// Keeps the end of a solve, from which the next goes on. Throws likewise.
  void end(std::size_t run, const Waypoint& waypoint);
  /// Whether what was solved is there for the next command.
  bool is_kept() const;

 private:
  void open_states();
  void require_all() const;
  void announce(std::size_t run) const;
  void warn(const std::string& text) const;
  template <class Write>
  void write(std::size_t run, Write write);

  const Session& session_;
  StateUse use_;
  std::filesystem::path folder_;
  std::vector<StateLock> locks_;                    // a run each: parts of a sweep may be solved at once
  std::vector<std::unique_ptr<TakeState>> states_;  // a run each; empty: none can be had
  bool was_given_up_ = false;
};

}  // namespace flexkey::cli
