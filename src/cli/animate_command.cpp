#include "cli/commands.h"

#include <fmt/format.h>

#include <optional>

#include "cli/conclusion.h"
#include "cli/console.h"
#include "cli/interrupt.h"
#include "cli/options.h"
#include "cli/run_outputs.h"
#include "cli/run_states.h"
#include "cli/session.h"
#include "cli/write_outputs.h"

namespace flexkey::cli {
namespace {

/// Solves what is not solved yet of a session's runs, and writes what they name; returns an exit code where a
/// signal stops it.
std::optional<int> write_family(const Session& session, StateUse use, Doings& doings) {
  RunStates states(session, use);
  note_signals();
  Outcome outcome = write_outputs(session, states);
  const std::size_t frames = outcome.reports.empty() ? 0 : outcome.reports.back().frames.size();
  if (noted_signal() != 0) return conclude_stopped(session, states, frames, std::move(outcome.fates));
  if (!session.options.quiet)
    for (const std::string& warning : outcome.warnings) say(fmt::format("{}\n", warning));
  for (std::string& result : results_of(outcome.reports)) doings.results.push_back(std::move(result));
  note(session, std::move(outcome.reports), doings);
  return std::nullopt;
}

/// Solves what is not solved yet, and writes what the shot names. All of it is checked before the first
/// solve.
int write_shot(const ShotOptions& options, Purpose purpose, StateUse use) {
  const ReadTimeline timeline = read_shot(options);
  const std::size_t count = timeline.families.size();
  for (std::size_t family = 1; family < count; ++family)
    require_outputs(open_session(timeline, family, options, purpose));
  Doings doings;
  for (std::size_t family = 0; family < count; ++family) {
    const Session session = open_session(timeline, family, options, purpose);
    say_warnings(session);
    require_outputs(session);
    if (const std::optional<int> stopped = write_family(session, use, doings)) return *stopped;
  }
  return conclude(options, doings);
}

StateUse use_of(const ShotOptions& options) {
  return options.no_solve ? StateUse::trusted : StateUse::helps;
}

}  // namespace

int run_animate(const ShotOptions& options) {
  return write_shot(options, Purpose::all, StateUse::helps);
}

int run_sweep(const ShotOptions& options) {
  ShotOptions all = options;
  if (!all.chunk) all.chunk = Chunk{};
  return write_shot(all, Purpose::all, StateUse::helps);
}

int run_export(const ShotOptions& options) {
  return write_shot(options, Purpose::files, use_of(options));
}

int run_render(const ShotOptions& options) {
  return write_shot(options, Purpose::pictures, use_of(options));
}

}  // namespace flexkey::cli
