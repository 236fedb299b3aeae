#include "cli/commands.h"
#include "cli/conclusion.h"
#include "cli/interrupt.h"
#include "cli/run_states.h"
#include "cli/session.h"
#include "cli/solve_runs.h"

namespace flexkey::cli {
namespace {

/// Solves the runs of a session; returns an exit code where a signal stops it.
std::optional<int> solve_family(const Session& session, Doings& doings) {
  RunStates states(session, StateUse::needed);
  note_signals();
  std::vector<RunReport> reports;
  {
    Progress progress(session.step_count() * static_cast<int>(session.runs.size()),
                      verbosity_of(session.options));
    for (const Batch& batch : batches_of(session)) {
      for (RunFrames& frames : frames_of(session, states, batch, {}, progress))
        reports.push_back(std::move(frames.report));
      if (noted_signal() != 0) return conclude_stopped(session, states, reports.back().frames.size(), {});
    }
  }
  if (doings.results.empty()) doings.results.push_back(states.folder().string());
  note(session, std::move(reports), doings);
  return std::nullopt;
}

}  // namespace

int run_solve(const ShotOptions& options) {
  const ReadTimeline timeline = read_shot(options);
  Doings doings;
  for (std::size_t family = 0; family < timeline.families.size(); ++family) {
    const Session session = open_session(timeline, family, options, Purpose::files);
    say_warnings(session);
    if (const std::optional<int> stopped = solve_family(session, doings)) return *stopped;
  }
  return conclude(options, doings);
}

}  // namespace flexkey::cli
