#include "cli/commands.h"
#include "cli/conclusion.h"
#include "cli/interrupt.h"
#include "cli/run_outputs.h"
#include "cli/run_states.h"
#include "cli/session.h"
#include "cli/solve_runs.h"

namespace flexkey::cli {
namespace {

std::vector<RunOutputs> open_outputs(const Session& session, const Batch& batch) {
  std::vector<RunOutputs> outputs;
  for (std::size_t k = 0; k < batch.count; ++k) outputs.emplace_back(session, batch.first + k);
  return outputs;
}

/// The paths of what was written.
std::vector<std::string> results_of(const std::vector<RunReport>& reports) {
  std::vector<std::string> results;
  for (const RunReport& report : reports) {
    for (const WrittenFile& file : report.written) results.push_back(file.path.string());
    for (const WrittenCache& cache : report.caches) results.push_back(cache.path.string());
    for (const WrittenPage& page : report.pages) results.push_back(page.path.string());
  }
  return results;
}

/// Solves what is not solved yet, and writes what the shot names.
int write_outputs(const ShotOptions& options, StateUse use) {
  const Session session = open_session(options);
  require_outputs(session);
  RunStates states(session, use);
  note_signals();
  std::vector<RunReport> reports;
  {
    Progress progress(session.frame_count() * static_cast<int>(session.runs.size()), verbosity_of(options));
    for (const Batch& batch : batches_of(session)) {
      std::vector<RunOutputs> outputs = open_outputs(session, batch);
      FrameWish wish;
      wish.keep = needs_clip(session.loaded.shot) ? Keep::frames : Keep::nothing;
      wish.on_frame = [&](std::size_t run, const SolvedFrame& frame) {
        outputs[run - batch.first].add(frame);
      };
      std::vector<RunFrames> frames = frames_of(session, states, batch, wish, progress);
      if (noted_signal() != 0)
        return conclude_stopped(session, states, frames.front().report.frames.size(),
                                outputs.front().fates());
      double seconds = 0;
      for (const RunOutputs& output : outputs) seconds += output.seconds();
      for (std::size_t k = 0; k < batch.count; ++k) {
        frames[k].report.solve_seconds -= seconds / static_cast<double>(batch.count);
        outputs[k].finish(frames[k]);
        reports.push_back(std::move(frames[k].report));
      }
    }
  }
  return conclude(session, reports, results_of(reports));
}

}  // namespace

int run_animate(const ShotOptions& options) {
  return write_outputs(options, StateUse::helps);
}

int run_export(const ShotOptions& options) {
  return write_outputs(options, options.no_solve ? StateUse::trusted : StateUse::helps);
}

}  // namespace flexkey::cli
