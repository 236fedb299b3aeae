#include "cli/run_states.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/build_id.h"
#include "cli/console.h"

namespace flexkey::cli {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const Session& session) {
  const std::string& name = session.loaded.shot.name;
  const bool is_dots = name.find_first_not_of('.') == std::string::npos;  // "." and ".." are other folders
  return session.options.out_dir / ".flexkey" / (is_dots ? fmt::format("_{}", name) : name);
}

/// Of one run, named by its values, and where that would be too long by their hash.
fs::path folder_of_run(const fs::path& folder, const Shot& run) {
  constexpr std::size_t longest = 100;
  if (run.swept.empty()) return folder;
  std::string name;
  for (const SweptValue& value : run.swept)
    name += fmt::format("{}{}-{}", name.empty() ? "" : "_", value.key, value.text);
  std::replace(name.begin(), name.end(), '/', '_');
  return folder / (name.size() > longest ? hash_of({name}) : name);
}

StateLock lock_for(StateUse use, const fs::path& folder) {
  return use == StateUse::trusted ? StateLock::for_reading(folder) : StateLock::for_writing(folder);
}

}  // namespace

RunStates::RunStates(const Session& session, StateUse use)
    : session_(session), use_(use), folder_(folder_of(session)) {
  bool is_readable = true, is_warned = false;
  for (const Shot& run : session_.runs) {
    const fs::path folder = folder_of_run(folder_, run);
    const StateLock& lock = locks_.emplace_back(lock_for(use, folder));
    const std::string unusable = fmt::format("the state in '{}': {}", folder.string(), lock.fault());
    const bool is_kept = lock.holds() == StateLock::Holds::writing;
    const bool is_solved_elsewhere = lock.holds() == StateLock::Holds::nothing;
    if (use_ == StateUse::needed && !is_kept) throw OutputError(fmt::format("cannot keep {}", unusable));
    if (use_ == StateUse::helps && !is_kept && !is_warned) warn(fmt::format("cannot keep {}", unusable));
    is_warned = is_warned || !is_kept;
    std::error_code ignored;
    if (use_ == StateUse::trusted && is_solved_elsewhere && fs::exists(folder / "lock", ignored))
      throw OutputError(fmt::format("cannot read {}", unusable));
    is_readable = is_readable && !is_solved_elsewhere;
  }
  if (is_readable) open_states();
  if (use_ == StateUse::trusted) require_all();
}

bool RunStates::is_kept() const {
  const auto writes = [](const StateLock& lock) { return lock.holds() == StateLock::Holds::writing; };
  return !was_given_up_ && std::all_of(locks_.begin(), locks_.end(), writes);
}

void RunStates::open_states() {
  const std::string program = build_id();
  for (const Shot& run : session_.runs) {
    const Take take{run, session_.scene};
    states_.push_back(
        std::make_unique<TakeState>(folder_of_run(folder_, run), take, program, session_.wanted));
    if (use_ != StateUse::trusted && !session_.options.quiet) announce(states_.size() - 1);
  }
}

void RunStates::announce(std::size_t run) const {
  const TakeState& state = *states_[run];
  if (state.is_complete()) return;
  if (!state.fault().empty())
    say(fmt::format("note: the state in '{}' does not serve: {}; solving from frame {}\n",
                    state.folder().string(), state.fault(), state.next()));
  if (state.fault().empty() && state.next() > 0)
    say(fmt::format("note: going on from frame {} by the state in '{}'\n", state.next(),
                    state.folder().string()));
}

void RunStates::require_all() const {
  constexpr const char* remedy =
      "; solve it first ('flexkey solve' with the same options), or leave out --no-solve";
  if (states_.empty()) throw UsageError(fmt::format("there is no state in '{}'{}", folder_.string(), remedy));
  for (const std::unique_ptr<TakeState>& state : states_) {
    const std::string place = state->folder().string();
    if (state->is_complete()) continue;
    if (!state->fault().empty())
      throw UsageError(fmt::format("the state in '{}' is stale: {}{}", place, state->fault(), remedy));
    throw UsageError(fmt::format("the state in '{}' has {} of {} frames{}", place, state->frames(),
                                 session_.step_count(), remedy));
  }
}

template <class Write>
void RunStates::write(std::size_t run, Write write) {
  if (!is_kept()) return;
  try {
    write(*states_[run]);
  } catch (const OutputError& error) {
    if (use_ == StateUse::needed) throw;
    was_given_up_ = true;
    states_[run]->remove();
    warn(fmt::format("{}; solving on without a state", error.what()));
  }
}

const TakeState* RunStates::kept(std::size_t run) const {
  const TakeState* state = of(run);
  return state != nullptr && (state->is_complete() || is_kept()) ? state : nullptr;
}

void RunStates::add(std::size_t run, const SolvedStep& step) {
  write(run, [&](TakeState& state) {
    state.add(step.report, step.positions);
    if (state.wants_checkpoint()) state.save_checkpoint(step.waypoint);
  });
}

void RunStates::end(std::size_t run, const Waypoint& waypoint) {
  write(run, [&](TakeState& state) { state.save_checkpoint(waypoint); });
}

void RunStates::warn(const std::string& text) const {
  if (!session_.options.quiet) say(fmt::format("warning: {}\n", text));
}

}  // namespace flexkey::cli
