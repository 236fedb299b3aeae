#include "flexkey/animate/animate.h"

#include <algorithm>

#include "flexkey/animate/deform_options.h"
#include "flexkey/animate/file_positions.h"
#include "flexkey/animate/handle_matrices.h"
#include "flexkey/animate/handle_states.h"
#include "flexkey/animate/legs.h"
#include "flexkey/animate/waypoint.h"
#include "flexkey/timeline/sampling.h"

namespace flexkey {
namespace {

/// A take on its way.
struct Running {
  const Take& take;
  int count = 0;               // of the frames to go through
  int taken = 0;               // of them, those that were solved before
  std::optional<Waypoint> at;  // none: no more are left to solve
  Clip clip;
};

/// The states with the targets of what fades drawn to where its vertices are without it.
HandleStates faded(const Scene& scene, HandleStates states, const Pose& without_fading, double time) {
  for (const int h : active_at(scene, time)) {
    const SceneHandle& bound = scene.handles[static_cast<std::size_t>(h)];
    const double grip = sample_grip(bound.handle, time);
    if (grip == 1) continue;
    const Positions free = without_fading.positions(bound.vertices, Eigen::all);
    states.curves[static_cast<std::size_t>(h)] = free + grip * (targets_of(scene, states, h) - free);
  }
  return states;
}

/// While some handles fade, a second passage runs without them, and they go to x + a (target − x), x where
/// their vertices are on it and a of sample_grip.
std::vector<SolveReport> advance_without_fading(const std::vector<Running*>& runs, int frame,
                                                DeformerCache& cache) {
  std::vector<Passage*> passages;
  std::vector<Leg> legs;
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    Running& run = *runs[k];
    const double time = frame / run.take.shot.fps;
    const ActiveSet firm = firm_at(run.take.scene, time);
    std::optional<Passage>& without_fading = run.at->without_fading;
    if (firm == active_at(run.take.scene, time)) {
      without_fading.reset();
      continue;
    }
    if (!without_fading) without_fading = run.at->passage;
    passages.push_back(&*without_fading);
    legs.push_back(leg_of(run.take, firm, frame));
    places.push_back(k);
  }
  const std::vector<SolveReport> solved = advance(passages, legs, cache);
  std::vector<SolveReport> reports(runs.size(), {.converged = true});
  for (std::size_t n = 0; n < places.size(); ++n) reports[places[n]] = solved[n];
  return reports;
}

/// Solves one frame of every take. A report counts the solves of both passages.
std::vector<SolveReport> solve_frame(const std::vector<Running*>& runs, int frame, DeformerCache& cache) {
  const std::vector<SolveReport> aside = advance_without_fading(runs, frame, cache);
  std::vector<Passage*> passages;
  std::vector<Leg> legs;
  for (Running* run : runs) {
    const double time = frame / run->take.shot.fps;
    passages.push_back(&run->at->passage);
    legs.push_back(leg_of(run->take, active_at(run->take.scene, time), frame));
    if (const std::optional<Passage>& without_fading = run->at->without_fading)
      legs.back().now = faded(run->take.scene, std::move(legs.back().now), without_fading->pose, time);
  }
  std::vector<SolveReport> reports = advance(passages, legs, cache);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    reports[k].solves += aside[k].solves;
    reports[k].converged = reports[k].converged && aside[k].converged;
    runs[k]->at->next = frame + 1;
  }
  return reports;
}

void require_one_batch(std::span<const Take> takes) {
  const Constraints& first = takes.front().scene.constraints;
  for (const Take& take : takes) {
    const Constraints& other = take.scene.constraints;
    if (other.handles != first.handles || other.region != first.region || other.owner != first.owner ||
        other.strengths != first.strengths || other.rigid != first.rigid)
      throw DeformError("shots that are solved together must have the same handles and region");
  }
}

/// Where a take starts: at rest, or behind the frames that were solved before.
Running start_of(const Take& take, int count, DeformerCache& cache) {
  Running run{take, count, 0, std::nullopt, {}};
  if (take.before != nullptr && take.before->frames() >= count) {
    run.taken = count;
    return run;
  }
  if (take.before != nullptr) run.at = take.before->waypoint(cache);
  if (!run.at) run.at = first_waypoint(take.scene, cache);
  run.taken = run.at->next;
  return run;
}

std::vector<Running> start_all(std::span<const Take> takes, const Mesh& mesh, const std::vector<int>& wanted,
                               DeformerCache& cache) {
  std::vector<Running> runs;
  for (const Take& take : takes) {
    const int count = take.shot.frame_count();
    runs.push_back(start_of(take, wanted.empty() ? count : std::min(count, wanted.back() + 1), cache));
    runs.back().clip.name = take.shot.name;
    runs.back().clip.mesh = mesh;
    runs.back().clip.fps = take.shot.fps;
  }
  return runs;
}

/// Who hears of the frames.
struct Audience {
  const AnimateHooks& hooks;
  const std::vector<int>& wanted;  // empty: all

  bool wants(int frame) const {
    return wanted.empty() || std::binary_search(wanted.begin(), wanted.end(), frame);
  }
};

/// Passes a wanted frame on and keeps what is to be kept of it.
void deliver(Running& run, std::size_t take, const FrameReport& report, Positions positions,
             const AnimateHooks& hooks) {
  if (hooks.on_wanted) {
    const std::vector<Eigen::Matrix4d> handles =
        handle_matrices(run.take.scene, report.frame / run.take.shot.fps);
    hooks.on_wanted(take, {report, positions, handles});
  }
  if (hooks.keep == Keep::frames) run.clip.frames.push_back(std::move(positions));
  run.clip.reports.push_back(report);
}

/// The frames that were solved before.
void deliver_taken(Running& run, std::size_t take, const Audience& audience) {
  for (int frame = 0; frame < run.taken; ++frame) {
    if (audience.hooks.stop && audience.hooks.stop()) return;
    const FrameReport& report = run.take.before->report(frame);
    if (audience.wants(frame)) deliver(run, take, report, run.take.before->positions(frame), audience.hooks);
    if (audience.hooks.on_frame) audience.hooks.on_frame(take, report);
  }
}

void deliver_solved(Running& run, std::size_t take, const SolveReport& solved, const Audience& audience) {
  const auto& [hooks, wanted] = audience;
  const int frame = run.at->next - 1;
  const double lambda = sample_lambda(run.take.shot.lambda, frame / run.take.shot.fps);
  const FrameReport report{frame, lambda, solved.solves, solved.estimate, solved.converged, solved.slipped};
  if (hooks.on_solved || audience.wants(frame)) {
    Positions positions = file_positions(run.take.scene, run.at->passage.pose);
    if (hooks.on_solved) hooks.on_solved(take, {report, positions, *run.at});
    if (audience.wants(frame)) deliver(run, take, report, std::move(positions), hooks);
  }
  if (hooks.on_frame) hooks.on_frame(take, report);
}

/// Those that have this frame still to solve.
std::vector<Running*> running_at(std::vector<Running>& runs, int frame) {
  std::vector<Running*> running;
  for (Running& run : runs)
    if (run.at && run.at->next == frame && frame < run.count) running.push_back(&run);
  return running;
}

}  // namespace

Positions sample_targets(const Scene& scene, double time) {
  return targets_of(scene, sample_states(scene, time));
}

std::vector<Clip> animate(std::span<const Take> takes, const Mesh& mesh, const std::vector<int>& wanted,
                          const AnimateHooks& hooks) {
  if (takes.empty()) return {};
  require_one_batch(takes);
  const Take& first = takes.front();
  DeformerCache cache(first.scene, deform_options(first.shot.solver));
  std::vector<Running> runs = start_all(takes, mesh, wanted, cache);
  const Audience audience{hooks, wanted};
  int last = 0;
  for (std::size_t take = 0; take < runs.size(); ++take) {
    deliver_taken(runs[take], take, audience);
    last = std::max(last, runs[take].count - 1);
  }
  for (int frame = 0; frame <= last; ++frame) {
    const std::vector<Running*> running = running_at(runs, frame);
    if (running.empty()) continue;
    if (hooks.stop && hooks.stop()) break;
    const std::vector<SolveReport> solved = solve_frame(running, frame, cache);
    for (std::size_t k = 0; k < running.size(); ++k)
      deliver_solved(*running[k], static_cast<std::size_t>(running[k] - runs.data()), solved[k], audience);
  }
  for (std::size_t take = 0; take < runs.size(); ++take)
    if (hooks.on_end && runs[take].at) hooks.on_end(take, *runs[take].at);
  std::vector<Clip> clips;
  for (Running& run : runs) clips.push_back(std::move(run.clip));
  return clips;
}

Clip animate(const Shot& shot, const Mesh& mesh, const Scene& scene, const std::vector<int>& wanted,
             const AnimateHooks& hooks) {
  const Take take{shot, scene};
  return std::move(animate(std::span(&take, 1), mesh, wanted, hooks).front());
}

Clip animate(const Shot& shot, const Mesh& mesh) {
  return animate(shot, mesh, bind_shot(shot, mesh));
}

}  // namespace flexkey
