#include "flexkey/animate/animate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "flexkey/animate/handle_states.h"

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
    case SolverSettings::Weights::uniform:
      options.weights = Weights::uniform;
      break;
  }
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

/// One frame's way for the handles.
struct FrameStep {
  const HandleStates& from;
  const HandleStates& to;
  double lambda;
  double max_step;  // radians
};

/// Solves from one state of the handles to the next, in as many equal steps as keep each turn within
/// max_step.
SolveReport solve_frame(const Deformer& deformer, const Scene& scene, const FrameStep& step, Pose& pose) {
  const Positions turns = turns_between(step.from, step.to);
  const double largest = turns.rows() > 0 ? turns.rowwise().norm().maxCoeff() : 0;
  const int parts = std::max(1, static_cast<int>(std::ceil(largest / step.max_step - 1e-9)));
  SolveReport report;
  int solves = 0;
  for (int part = 1; part <= parts; ++part) {
    const HandleStates at =
        part == parts ? step.to : blend(step.from, step.to, static_cast<double>(part) / parts);
    report = deformer.solve({targets_of(scene, at), turns / parts}, step.lambda, pose);
    solves += report.solves;
  }
  report.solves = solves;
  return report;
}

}  // namespace

Positions sample_targets(const Scene& scene, double time) {
  return targets_of(scene, sample_states(scene, time));
}

Clip animate(const Shot& shot, const Mesh& mesh, const Scene& scene, const std::vector<int>& wanted,
             const AnimateHooks& hooks) {
  const Deformer deformer(scene.weld.surface, scene.constraints, deform_options(shot.solver));
  Clip clip;
  clip.name = shot.name;
  clip.mesh = mesh;
  clip.fps = shot.fps;
  Pose pose = deformer.rest_pose();
  HandleStates before = rest_states(scene);
  const int last = wanted.empty() ? shot.frame_count() - 1 : wanted.back();
  for (int frame = 0; frame <= last; ++frame) {
    if (hooks.stop && hooks.stop()) break;
    const double time = frame / shot.fps;
    const double lambda = sample_lambda(shot.lambda, time);
    const HandleStates now = sample_states(scene, time);
    const SolveReport solved =
        solve_frame(deformer, scene, {before, now, lambda, shot.solver.max_step}, pose);
    before = now;
    const FrameReport report{frame, lambda, solved.solves, solved.estimate, solved.converged};
    if (wanted.empty() || std::binary_search(wanted.begin(), wanted.end(), frame)) {
      clip.frames.push_back(file_positions(scene, pose));
      clip.reports.push_back(report);
    }
    if (hooks.on_frame) hooks.on_frame(report);
  }
  return clip;
}

Clip animate(const Shot& shot, const Mesh& mesh) {
  return animate(shot, mesh, bind_shot(shot, mesh));
}

}  // namespace flexkey
