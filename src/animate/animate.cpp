#include "flexkey/animate/animate.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "flexkey/animate/handle_matrices.h"
#include "flexkey/animate/handle_states.h"
#include "flexkey/animate/lambda_field.h"
#include "flexkey/animate/passage.h"
#include "flexkey/timeline/sampling.h"

namespace flexkey {
namespace {

DeformOptions deform_options(const SolverSettings& solver) {
  DeformOptions options;
  switch (solver.system) {
    case SolverSettings::System::least_squares:
      options.system = System::least_squares;
      break;
    case SolverSettings::System::direct:
      options.system = System::direct;
      break;
  }
  switch (solver.local_scale) {
    case SolverSettings::LocalScale::axis:
      options.local_scale = LocalScale::axis;
      break;
    case SolverSettings::LocalScale::uniform:
      options.local_scale = LocalScale::uniform;
      break;
    case SolverSettings::LocalScale::none:
      options.local_scale = LocalScale::none;
      break;
  }
  switch (solver.weights) {
    case SolverSettings::Weights::clamped:
      options.weights = Weights::clamped;
      break;
    case SolverSettings::Weights::cotangent:
      options.weights = Weights::cotangent;
      break;
    case SolverSettings::Weights::intrinsic_delaunay:
      options.weights = Weights::intrinsic_delaunay;
      break;
    case SolverSettings::Weights::uniform:
      options.weights = Weights::uniform;
      break;
  }
  switch (solver.cell) {
    case SolverSettings::Cell::spokes:
      options.cell = Cell::spokes;
      break;
    case SolverSettings::Cell::spokes_and_rims:
      options.cell = Cell::spokes_and_rims;
      break;
  }
  options.area_weighting = solver.area_weighting;
  options.epsilon = solver.epsilon;
  options.iterations = solver.iterations;
  options.tolerance = solver.tolerance;
  options.predict = solver.predict;
  options.accelerate = solver.accelerate;
  options.fixed_count = solver.preset == SolverSettings::Preset::paper;
  return options;
}

/// The rigid motion that best takes a patch from rest to where it is (Kabsch).
Eigen::Isometry3d rigid_motion(const Positions& rest, const Positions& posed) {
  if (rest == posed) return Eigen::Isometry3d::Identity();  // to the last bit, so that rest stays rest
  return Eigen::Isometry3d(Eigen::umeyama(rest.transpose(), posed.transpose(), false));
}

/// The pose's positions with what rides on it, given back to the file's vertices.
Positions file_positions(const Scene& scene, const Pose& pose) {
  const Positions& rest = scene.weld.surface.positions;
  Positions positions = pose.positions;
  for (const Rider& rider : scene.riders) {
    const Eigen::Isometry3d motion =
        rigid_motion(rest(rider.carriers, Eigen::all), pose.positions(rider.carriers, Eigen::all));
    for (const int v : rider.vertices)
      positions.row(v) = (motion * Vec3(rest.row(v).transpose())).transpose();
  }
  return scatter(scene.weld, positions);
}

/// A take on its way.
struct Running {
  const Take& take;
  Passage passage;
  std::optional<Passage> without_fading;  // while handles fade
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

/// The next leg of a take; set: active_at or firm_at.
Leg leg_of(const Take& take, const ActiveSet& active, double time) {
  return {take.scene, active, sample_states(take.scene, time), lambda_at(take.shot, take.scene, time),
          take.shot.solver.max_step};
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
    if (firm == active_at(run.take.scene, time)) {
      run.without_fading.reset();
      continue;
    }
    if (!run.without_fading) run.without_fading = run.passage;
    passages.push_back(&*run.without_fading);
    legs.push_back(leg_of(run.take, firm, time));
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
    passages.push_back(&run->passage);
    legs.push_back(leg_of(run->take, active_at(run->take.scene, time), time));
    if (run->without_fading)
      legs.back().now = faded(run->take.scene, std::move(legs.back().now), run->without_fading->pose, time);
  }
  std::vector<SolveReport> reports = advance(passages, legs, cache);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    reports[k].solves += aside[k].solves;
    reports[k].converged = reports[k].converged && aside[k].converged;
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

std::vector<Running> start_all(std::span<const Take> takes, const Mesh& mesh, DeformerCache& cache) {
  std::vector<Running> runs;
  for (const Take& take : takes) {
    runs.push_back({take, start_of(take.scene, cache), std::nullopt, {}});
    runs.back().clip.name = take.shot.name;
    runs.back().clip.mesh = mesh;
    runs.back().clip.fps = take.shot.fps;
  }
  return runs;
}

/// Passes a wanted frame on and keeps what is to be kept of it.
void deliver(Running& run, std::size_t take, const FrameReport& report, const AnimateHooks& hooks) {
  const Scene& scene = run.take.scene;
  Positions positions = file_positions(scene, run.passage.pose);
  if (hooks.on_wanted) {
    const std::vector<Eigen::Matrix4d> handles = handle_matrices(scene, report.frame / run.take.shot.fps);
    hooks.on_wanted(take, {report, positions, handles});
  }
  if (hooks.keep == Keep::frames) run.clip.frames.push_back(std::move(positions));
  run.clip.reports.push_back(report);
}

int last_frame(std::span<const Take> takes, const std::vector<int>& wanted) {
  if (!wanted.empty()) return wanted.back();
  int count = 0;
  for (const Take& take : takes) count = std::max(count, take.shot.frame_count());
  return count - 1;
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
  std::vector<Running> runs = start_all(takes, mesh, cache);
  const int last = last_frame(takes, wanted);
  for (int frame = 0; frame <= last; ++frame) {
    if (hooks.stop && hooks.stop()) break;
    std::vector<Running*> running;
    for (Running& run : runs)
      if (frame < run.take.shot.frame_count()) running.push_back(&run);
    const std::vector<SolveReport> solved = solve_frame(running, frame, cache);
    const bool is_wanted = wanted.empty() || std::binary_search(wanted.begin(), wanted.end(), frame);
    for (std::size_t k = 0; k < running.size(); ++k) {
      Running& run = *running[k];
      const FrameReport report{frame,
                               sample_lambda(run.take.shot.lambda, frame / run.take.shot.fps),
                               solved[k].solves,
                               solved[k].estimate,
                               solved[k].converged,
                               solved[k].slipped};
      const auto take = static_cast<std::size_t>(&run - runs.data());
      if (is_wanted) deliver(run, take, report, hooks);
      if (hooks.on_frame) hooks.on_frame(take, report);
    }
  }
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
