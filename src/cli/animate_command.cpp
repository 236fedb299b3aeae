#include "cli/commands.h"

#include <fmt/format.h>

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

/// Solves what is not solved yet, writes what the session's shot names, and reports.
int write_and_report(const Session& session, StateUse use) {
  require_outputs(session);
  RunStates states(session, use);
  note_signals();
  Outcome outcome = write_outputs(session, states);
  const std::size_t frames = outcome.reports.empty() ? 0 : outcome.reports.back().frames.size();
  if (noted_signal() != 0) return conclude_stopped(session, states, frames, std::move(outcome.fates));
  if (!session.options.quiet)
    for (const std::string& warning : outcome.warnings) say(fmt::format("{}\n", warning));
  return conclude(session, outcome.reports, results_of(outcome.reports));
}

StateUse use_of(const ShotOptions& options) {
  return options.no_solve ? StateUse::trusted : StateUse::helps;
}

}  // namespace

int run_animate(const ShotOptions& options) {
  return write_and_report(open_session(options, Purpose::all), StateUse::helps);
}

int run_export(const ShotOptions& options) {
  return write_and_report(open_session(options, Purpose::files), use_of(options));
}

int run_render(const ShotOptions& options) {
  return write_and_report(open_session(options, Purpose::pictures), use_of(options));
}

}  // namespace flexkey::cli
