#include "cli/commands.h"
#include "cli/conclusion.h"
#include "cli/interrupt.h"
#include "cli/run_states.h"
#include "cli/session.h"
#include "cli/solve_runs.h"

namespace flexkey::cli {

int run_solve(const ShotOptions& options) {
  const Session session = open_session(options, Purpose::files);
  RunStates states(session, StateUse::needed);
  note_signals();
  std::vector<RunReport> reports;
  {
    Progress progress(session.step_count() * static_cast<int>(session.runs.size()), verbosity_of(options));
    for (const Batch& batch : batches_of(session)) {
      for (RunFrames& frames : frames_of(session, states, batch, {}, progress))
        reports.push_back(std::move(frames.report));
      if (noted_signal() != 0) return conclude_stopped(session, states, reports.back().frames.size(), {});
    }
  }
  return conclude(session, reports, {states.folder().string()});
}

}  // namespace flexkey::cli
