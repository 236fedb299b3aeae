#include "flexkey/animate/animate.h"

#include <algorithm>

#include "flexkey/animate/deform_options.h"
#include "flexkey/animate/file_positions.h"
#include "flexkey/animate/handle_states.h"
#include "flexkey/animate/laps.h"
#include "flexkey/animate/legs.h"
#include "flexkey/animate/playing.h"
#include "flexkey/animate/waypoint.h"
#include "flexkey/timeline/sampling.h"
#include "flexkey/timeline/steps.h"

namespace flexkey {
namespace {

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
std::vector<SolveReport> advance_without_fading(const std::vector<Running*>& runs, int step,
                                                DeformerCache& cache) {
  std::vector<Passage*> passages;
  std::vector<Leg> legs;
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    Running& run = *runs[k];
    const double time = time_of_step(run.take.shot, step);
    const ActiveSet firm = firm_at(run.take.scene, time);
    std::optional<Passage>& without_fading = run.at->without_fading;
    if (firm == active_at(run.take.scene, time)) {
      without_fading.reset();
      continue;
    }
    if (!without_fading) without_fading = run.at->passage;
    passages.push_back(&*without_fading);
    legs.push_back(leg_of(run.take, firm, step));
    places.push_back(k);
  }
  const std::vector<SolveReport> solved = advance(passages, legs, cache);
  std::vector<SolveReport> reports(runs.size(), {.converged = true});
  for (std::size_t n = 0; n < places.size(); ++n) reports[places[n]] = solved[n];
  return reports;
}

/// Where another lap of a cycle begins.
void begin_lap(Running& run, int step) {
  const std::vector<std::vector<double>> turns = turns_to_unwind(run.take, step);
  run.at->passage.before = unwound(std::move(run.at->passage.before), turns);
  if (std::optional<Passage>& without_fading = run.at->without_fading)
    without_fading->before = unwound(std::move(without_fading->before), turns);
}

/// Solves one step of every take. A report counts the solves of both passages.
std::vector<SolveReport> solve_step(const std::vector<Running*>& runs, int step, DeformerCache& cache) {
  for (Running* run : runs) begin_lap(*run, step);
  const std::vector<SolveReport> aside = advance_without_fading(runs, step, cache);
  std::vector<Passage*> passages;
  std::vector<Leg> legs;
  for (Running* run : runs) {
    const double time = time_of_step(run->take.shot, step);
    passages.push_back(&run->at->passage);
    legs.push_back(leg_of(run->take, active_at(run->take.scene, time), step));
    if (const std::optional<Passage>& without_fading = run->at->without_fading)
      legs.back().now = faded(run->take.scene, std::move(legs.back().now), without_fading->pose, time);
  }
  std::vector<SolveReport> reports = advance(passages, legs, cache);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    reports[k].solves += aside[k].solves;
    reports[k].converged = reports[k].converged && aside[k].converged;
    runs[k]->at->next = step + 1;
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

/// Where a take starts: at rest, or behind the steps that were solved before.
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
    runs.push_back(start_of(take, steps_until(take.shot, wanted), cache));
    runs.back().clip.name = take.shot.name;
    runs.back().clip.mesh = mesh;
    runs.back().clip.fps = take.shot.fps;
    if (take.shot.loop == Loop::cycle) runs.back().clip.period = take.shot.frame_count();
  }
  return runs;
}

/// The steps that were solved before.
void deliver_taken(Running& run, std::size_t take, const Audience& audience) {
  for (int step = 0; step < run.taken; ++step) {
    if (audience.hooks.stop && audience.hooks.stop()) return;
    const bool is_needed = needs_positions(run, step, audience);
    deliver(run, take,
            {run.take.before->report(step), is_needed ? run.take.before->positions(step) : Positions()},
            audience);
  }
}

void deliver_solved(Running& run, std::size_t take, const SolveReport& solved, const Audience& audience) {
  const int step = run.at->next - 1;
  const double lambda = sample_lambda(run.take.shot.lambda, time_of_step(run.take.shot, step));
  const FrameReport report{step, lambda, solved.solves, solved.estimate, solved.converged, solved.slipped};
  Positions positions;
  if (audience.hooks.on_solved || needs_positions(run, step, audience))
    positions = file_positions(run.take.scene, run.at->passage.pose);
  if (audience.hooks.on_solved) audience.hooks.on_solved(take, {report, positions, *run.at});
  deliver(run, take, {report, std::move(positions)}, audience);
}

/// Those that have this step still to solve.
std::vector<Running*> running_at(std::vector<Running>& runs, int step) {
  std::vector<Running*> running;
  for (Running& run : runs)
    if (run.at && run.at->next == step && step < run.count) running.push_back(&run);
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
  for (int step = 0; step <= last; ++step) {
    const std::vector<Running*> running = running_at(runs, step);
    if (running.empty()) continue;
    if (hooks.stop && hooks.stop()) break;
    const std::vector<SolveReport> solved = solve_step(running, step, cache);
    for (std::size_t k = 0; k < running.size(); ++k)
      deliver_solved(*running[k], static_cast<std::size_t>(running[k] - runs.data()), solved[k], audience);
  }
  for (std::size_t take = 0; take < runs.size(); ++take)
    if (hooks.on_end && runs[take].at) hooks.on_end(take, *runs[take].at);
  for (std::size_t take = 0; take < runs.size(); ++take) deliver_way_back(runs[take], take, audience);
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
