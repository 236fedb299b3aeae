#include "cli/write_outputs.h"

#include "cli/interrupt.h"
#include "cli/previews.h"
#include "cli/run_outputs.h"
#include "cli/solve_runs.h"

namespace flexkey::cli {
namespace {

std::vector<RunOutputs> open_outputs(const Session& session, const Batch& batch) {
  std::vector<RunOutputs> outputs;
  for (std::size_t k = 0; k < batch.count; ++k) outputs.emplace_back(session, batch.first + k);
  return outputs;
}

/// Solves runs that are not solved yet, and writes what they name but for pictures that still wait.
void write_batch(const Session& session, const Batch& batch, RunStates& states, Previews& previews,
                 Progress& progress, Outcome& outcome) {
  std::vector<RunOutputs> outputs = open_outputs(session, batch);
  FrameWish wish;
  wish.keep = needs_clip(session.loaded.shot) ? Keep::frames : Keep::nothing;
  wish.on_frame = [&](std::size_t run, const SolvedFrame& frame) {
    previews.add(run, frame);
    if (is_picked(session, frame.report.frame)) outputs[run - batch.first].add(frame);
  };
  std::vector<RunFrames> frames = frames_of(session, states, batch, wish, progress);
  double seconds = 0;
  for (const RunOutputs& output : outputs) seconds += output.seconds();
  for (std::size_t k = 0; k < batch.count; ++k) {
    frames[k].report.solve_seconds -= seconds / static_cast<double>(batch.count);
    const bool is_finished = noted_signal() == 0 && outputs[k].finish(frames[k]);
    if (!is_finished && outcome.fates.empty()) outcome.fates = outputs[k].fates();
    outcome.reports.push_back(std::move(frames[k].report));
  }
}

/// Draws the pictures that have waited, and adds them to the reports.
void finish_previews(Previews& previews, Outcome& outcome) {
  const std::vector<WrittenPreview> written = previews.finish();
  for (std::size_t k = 0; k < written.size(); ++k) outcome.reports[k].previews.push_back(written[k]);
  outcome.warnings = previews.warnings();
}

}  // namespace

Outcome write_outputs(const Session& session, RunStates& states) {
  Previews previews(session, states);
  Outcome outcome;
  {
    Progress progress(session.step_count() * static_cast<int>(session.runs.size()),
                      verbosity_of(session.options));
    for (const Batch& batch : batches_of(session))
      if (noted_signal() == 0) write_batch(session, batch, states, previews, progress, outcome);
  }
  if (noted_signal() == 0) finish_previews(previews, outcome);
  if (noted_signal() != 0)
    for (std::string& fate : previews.fates()) outcome.fates.push_back(std::move(fate));
  return outcome;
}

std::vector<std::string> results_of(const std::vector<RunReport>& reports) {
  std::vector<std::string> results;
  for (const RunReport& report : reports) {
    for (const WrittenFile& file : report.written) results.push_back(file.path.string());
    for (const WrittenCache& cache : report.caches) results.push_back(cache.path.string());
    for (const WrittenPage& page : report.pages) results.push_back(page.path.string());
    for (const WrittenPreview& preview : report.previews) {
      results.push_back(preview.path.string());
      for (const std::filesystem::path& file : preview.files) results.push_back(file.string());
    }
  }
  return results;
}

}  // namespace flexkey::cli
