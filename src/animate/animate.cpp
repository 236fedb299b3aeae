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
  Pose pose;
  HandleStates before;
  Clip clip;
};

/// One frame's way for the handles of a take, in as many equal parts as keep each turn within max_step.
struct FrameWay {
  HandleStates from, to;
  Positions turns;
  double lambda = 0;
  int parts = 0;  // 0: the take is over

  FrameWay(const Running& run, int frame)
      : from(run.before),
        to(sample_states(run.take.scene, frame / run.take.shot.fps)),
        turns(turns_between(from, to)),
        lambda(sample_lambda(run.take.shot.lambda, frame / run.take.shot.fps)) {
    if (frame >= run.take.shot.frame_count()) return;
    const double largest = turns.rows() > 0 ? turns.rowwise().norm().maxCoeff() : 0;
    parts = std::max(1, static_cast<int>(std::ceil(largest / run.take.shot.solver.max_step - 1e-9)));
  }

  Frame part(const Scene& scene, int number) const {
    const bool is_last = number == parts;
    const HandleStates at = is_last ? to : blend(from, to, static_cast<double>(number) / parts);
    const auto count = scene.weld.surface.vertex_count();
    return {{targets_of(scene, at), turns / parts}, Eigen::VectorXd::Constant(count, lambda)};
  }
};

/// Solves one frame of every take.
std::vector<SolveReport> solve_frame(const Deformer& deformer, const std::vector<FrameWay>& ways,
                                     std::vector<Running>& runs) {
  std::vector<SolveReport> reports(runs.size());
  for (int part = 1;; ++part) {
    std::vector<Frame> frames;
    std::vector<Pose> poses;
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < runs.size(); ++k) {
      if (part > ways[k].parts) continue;
      frames.push_back(ways[k].part(runs[k].take.scene, part));
      poses.push_back(std::move(runs[k].pose));
      places.push_back(k);
    }
    if (places.empty()) return reports;
    const std::vector<SolveReport> solved = deformer.solve(frames, poses);
    for (std::size_t n = 0; n < places.size(); ++n) {
      const int before = reports[places[n]].solves;
      reports[places[n]] = solved[n];
      reports[places[n]].solves += before;
      runs[places[n]].pose = std::move(poses[n]);
    }
  }
}

void require_one_batch(std::span<const Take> takes) {
  const Constraints& first = takes.front().scene.constraints;
  for (const Take& take : takes) {
    const Constraints& other = take.scene.constraints;
    if (other.handles != first.handles || other.region != first.region || other.owner != first.owner)
      throw DeformError("shots that are solved together must have the same handles and region");
  }
}

std::vector<Running> start_all(std::span<const Take> takes, const Mesh& mesh, const Deformer& deformer) {
  std::vector<Running> runs;
  for (const Take& take : takes) {
    runs.push_back({take, deformer.rest_pose(), rest_states(take.scene), {}});
    runs.back().clip.name = take.shot.name;
    runs.back().clip.mesh = mesh;
    runs.back().clip.fps = take.shot.fps;
  }
  return runs;
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
  const Deformer deformer(first.scene.weld.surface, first.scene.constraints,
                          deform_options(first.shot.solver));
  std::vector<Running> runs = start_all(takes, mesh, deformer);
  const int last = last_frame(takes, wanted);
  for (int frame = 0; frame <= last; ++frame) {
    if (hooks.stop && hooks.stop()) break;
    std::vector<FrameWay> ways;
    for (const Running& run : runs) ways.emplace_back(run, frame);
    const std::vector<SolveReport> solved = solve_frame(deformer, ways, runs);
    const bool is_wanted = wanted.empty() || std::binary_search(wanted.begin(), wanted.end(), frame);
    for (std::size_t k = 0; k < runs.size(); ++k) {
      Running& run = runs[k];
      if (ways[k].parts == 0) continue;
      run.before = ways[k].to;
      const FrameReport report{frame,
                               ways[k].lambda,
                               solved[k].solves,
                               solved[k].estimate,
                               solved[k].converged,
                               solved[k].slipped};
      if (is_wanted) {
        run.clip.frames.push_back(file_positions(run.take.scene, run.pose));
        run.clip.reports.push_back(report);
      }
      if (hooks.on_frame) hooks.on_frame(k, report);
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
