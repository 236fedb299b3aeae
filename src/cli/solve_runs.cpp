#include "cli/solve_runs.h"

#include <algorithm>

#include "cli/interrupt.h"
#include "cli/stopwatch.h"

namespace flexkey::cli {
namespace {

/// What becomes of frames as they come.
AnimateHooks hooks_for(RunStates& states, const Batch& batch, const FrameWish& wish, Progress& progress,
                       std::vector<RunFrames>& found) {
  AnimateHooks hooks;
  hooks.keep = wish.keep;
  if (wish.on_frame)
    hooks.on_wanted = [&](std::size_t k, const SolvedFrame& frame) { wish.on_frame(batch.first + k, frame); };
  hooks.on_solved = [&](std::size_t k, const SolvedStep& step) {
    states.add(batch.first + k, step);
    ++found[k].report.solved_now;
  };
  hooks.on_frame = [&](std::size_t k, const FrameReport& frame) {
    RunReport& report = found[k].report;
    report.frames.push_back(frame);
    report.solved_now > 0 ? progress.advance() : progress.pass();
  };
  hooks.on_end = [&](std::size_t k, const Waypoint& waypoint) { states.end(batch.first + k, waypoint); };
  hooks.stop = [] { return noted_signal() != 0; };
  return hooks;
}

/// Leaves out frames that are solved for and not written.
Clip picked_of(Clip clip, const Session& session) {
  if (session.wanted == session.picked) return clip;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < clip.reports.size(); ++k) {
    if (!is_picked(session, clip.reports[k].frame)) continue;
    clip.reports[kept] = clip.reports[k];
    if (!clip.frames.empty()) std::swap(clip.frames[kept], clip.frames[k]);
    ++kept;
  }
  clip.reports.resize(kept);
  if (!clip.frames.empty()) clip.frames.resize(kept);
  return clip;
}

}  // namespace

std::vector<Batch> batches_of(const Session& session) {
  constexpr std::size_t together = 5;
  std::vector<Batch> batches;
  for (std::size_t first = 0; first < session.runs.size(); first += together)
    batches.push_back({first, std::min(together, session.runs.size() - first)});
  return batches;
}

std::vector<RunFrames> frames_of(const Session& session, RunStates& states, const Batch& batch,
                                 const FrameWish& wish, Progress& progress) {
  std::vector<RunFrames> found(batch.count);
  std::vector<Take> takes;
  for (std::size_t k = 0; k < batch.count; ++k)
    takes.push_back({session.runs[batch.first + k], session.scene, states.of(batch.first + k)});
  const AnimateHooks hooks = hooks_for(states, batch, wish, progress, found);
  const Stopwatch watch;
  std::vector<Clip> clips = animate(takes, session.loaded.mesh, session.wanted, hooks);
  for (std::size_t k = 0; k < batch.count; ++k) {
    RunReport& report = found[k].report;
    report.gap = clips[k].gap;
    report.swept = takes[k].shot.swept;
    found[k].clip = picked_of(std::move(clips[k]), session);
    report.solve_seconds = watch.seconds() / static_cast<double>(batch.count);
    report.claims_convergence = takes[k].shot.solver.preset != SolverSettings::Preset::paper;
    if (report.frames.empty()) continue;
    report.lambda_first = report.frames.front().lambda;
    report.lambda_last = report.frames.back().lambda;
  }
  return found;
}

}  // namespace flexkey::cli
