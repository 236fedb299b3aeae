#include "flexkey/deform/deformer.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "flexkey/deform/checks.h"
#include "flexkey/deform/fixed_point.h"
#include "flexkey/deform/prediction.h"

namespace flexkey {

namespace {

/// The unknowns: the region without its handles. A vertex of no triangle has no equation and stays at rest.
std::vector<bool> free_vertices(const Constraints& constraints, const Cells& cells) {
  std::vector<bool> is_free(cells.count(), constraints.region.empty());
  for (const int v : constraints.region) is_free[v] = true;
  for (const int v : constraints.handles) is_free[v] = false;
  for (int v = 0; v < cells.count(); ++v) {
    if (cells.of(v).empty()) is_free[v] = false;
  }
  return is_free;
}

/// Whether the pose already is this frame's answer.
bool answers(const Pose& pose, const Positions& targets, const Eigen::VectorXd& lambda) {
  const bool same_lambda =
      pose.lambda.size() == 0 || (pose.lambda.size() == lambda.size() && pose.lambda == lambda);
  return pose.converged && same_lambda && pose.targets.rows() == targets.rows() && pose.targets == targets;
}

/// Each handle vertex's place in the patch, or -1 where no equation reads it.
std::vector<int> places_in(const Patch& patch, const std::vector<int>& handles, int mesh_vertex_count) {
  std::vector<int> place(mesh_vertex_count, -1);
  for (int i = 0; i < patch.vertex_count(); ++i) place[patch.vertices[i]] = i;
  std::vector<int> places;
  for (const int v : handles) places.push_back(place[v]);
  return places;
}

/// How each handle's turn spreads over the patch, #fitted x #handles.
Eigen::MatrixXd turn_weights(const Mesh& rest, const Cells& cells, const Constraints& constraints,
                             const Patch& patch, Weights weights) {
  std::vector<int> owner(rest.vertex_count(), -1);
  int handle_count = 0;
  for (std::size_t k = 0; k < constraints.handles.size(); ++k) {
    const int handle = constraints.owner.empty() ? 0 : constraints.owner[k];
    owner[constraints.handles[k]] = handle;
    handle_count = std::max(handle_count, handle + 1);
  }
  const bool is_clamped = weights == Weights::clamped;
  return harmonic_weights(is_clamped ? cells : build_cells(rest, Weights::clamped), patch, owner,
                          handle_count);
}

Problem make_problem(const Mesh& rest, const Constraints& constraints, const DeformOptions& options) {
  const Cells cells = build_cells(rest, options.weights);
  const std::vector<bool> is_free = free_vertices(constraints, cells);
  require_held(rest, cells, is_free);
  const Patch patch = make_patch(cells, rest.positions, is_free, options.system);
  Problem problem{options,
                  patch,
                  tabulate(patch),
                  LaplacianSystem(patch, options.system),
                  bounds_of(rest.positions).diagonal(),
                  {}};
  if (options.predict) problem.harmonic = turn_weights(rest, cells, constraints, patch, options.weights);
  return problem;
}

/// The two ways in which a frame's rotations are guessed before its first solve.
struct Guesses {
  Transforms turned;     // by the handles' turns, spread over the surface
  Transforms continued;  // each by its own last change
};

Guesses guess(const Problem& problem, const Transforms& last, const Pose& pose, const Positions& turns) {
  Guesses guesses{turns.rows() > 0 ? turned(last, problem.harmonic, turns) : last, last};
  if (pose.earlier.empty()) {
    guesses.continued = guesses.turned;
  } else {
    std::vector<Eigen::Matrix3d> earlier;
    for (int i = 0; i < problem.patch.fitted; ++i) earlier.push_back(pose.earlier[problem.patch.vertices[i]]);
    guesses.continued = continued(last, earlier);
  }
  return guesses;
}

Iterate gather(const Patch& patch, const Pose& pose) {
  Iterate at{pose.positions(patch.vertices, Eigen::all), {}, pose.stretch};
  at.transforms.scales.resize(patch.fitted, 3);
  for (int i = 0; i < patch.fitted; ++i) {
    at.transforms.rotations.push_back(pose.rotations[patch.vertices[i]]);
    at.transforms.scales.row(i) = pose.scales.row(patch.vertices[i]);
  }
  return at;
}

void scatter(const Patch& patch, const Iterate& at, Pose& pose) {
  for (int i = 0; i < patch.free; ++i) pose.positions.row(patch.vertices[i]) = at.positions.row(i);
  for (int i = 0; i < patch.fitted; ++i) {
    pose.rotations[patch.vertices[i]] = at.transforms.rotations[i];
    pose.scales.row(patch.vertices[i]) = at.transforms.scales.row(i);
  }
}

}  // namespace

struct Deformer::State {
  Positions rest;                  // #V x 3
  std::vector<int> handles;        // mesh vertices, in the order of the targets
  std::vector<int> handle_places;  // of each handle vertex in the patch, or -1
  Problem problem;
};

Deformer::Deformer(const Mesh& rest, const Constraints& constraints, const DeformOptions& options) {
  require_sound(options);
  require_sound(rest);
  require_sound(constraints, rest.vertex_count());
  Problem problem = make_problem(rest, constraints, options);
  std::vector<int> places = places_in(problem.patch, constraints.handles, rest.vertex_count());
  state_ = std::make_unique<State>(
      State{rest.positions, constraints.handles, std::move(places), std::move(problem)});
}

Deformer::~Deformer() = default;
Deformer::Deformer(Deformer&&) noexcept = default;
Deformer& Deformer::operator=(Deformer&&) noexcept = default;

Pose Deformer::rest_pose() const {
  Pose pose;
  pose.positions = state_->rest;
  pose.rotations.assign(state_->rest.rows(), Eigen::Matrix3d::Identity());
  pose.scales = Positions::Ones(state_->rest.rows(), 3);
  pose.targets = state_->rest(state_->handles, Eigen::all);
  pose.converged = true;
  return pose;
}

Pose Deformer::pose_at(const Positions& positions) const {
  const auto& [rest, handles, handle_places, problem] = *state_;
  require_positions(positions, rest.rows());
  Pose pose = rest_pose();
  for (int i = 0; i < problem.patch.free; ++i) {
    const int v = problem.patch.vertices[i];
    pose.positions.row(v) = positions.row(v);
  }
  pose.targets = positions(handles, Eigen::all);
  pose.positions(handles, Eigen::all) = pose.targets;
  Iterate at = gather(problem.patch, pose);
  local_step(problem.cells, problem.options, at.positions, at.transforms);
  scatter(problem.patch, at, pose);
  pose.converged = false;
  pose.started = true;
  return pose;
}

SolveReport Deformer::solve(const Targets& targets, double lambda, Pose& pose) const {
  return solve(targets, Eigen::VectorXd::Constant(state_->rest.rows(), lambda), pose);
}

SolveReport Deformer::solve(const Targets& targets, const Eigen::VectorXd& lambda, Pose& pose) const {
  const auto& [rest, handles, handle_places, problem] = *state_;
  const DeformOptions& options = problem.options;
  const Patch& patch = problem.patch;
  require_targets(targets.positions, handles.size());
  require_turns(targets.turns, problem.harmonic.cols(), options.predict);
  require_lambda(lambda, rest.rows());
  require_pose(pose, rest.rows());
  if (answers(pose, targets.positions, lambda)) {
    pose.started = true;
    pose.earlier = pose.rotations;
    return {.converged = !options.fixed_count};
  }
  Iterate from = gather(patch, pose);
  for (std::size_t h = 0; h < handles.size(); ++h) {
    if (handle_places[h] >= 0) from.positions.row(handle_places[h]) = targets.positions.row(h);
  }
  std::optional<Guesses> guesses;
  if (options.predict) {
    guesses = guess(problem, from.transforms, pose, targets.turns);
    from.transforms = pose.continues ? guesses->continued : guesses->turned;
  }
  // From rest, R = S = 1 makes the first solve the naive Laplacian one that the paper starts from.
  const int naive_start = options.fixed_count && !pose.started ? 1 : 0;
  const FixedPoint found =
      iterate(problem, std::move(from), lambda(patch.vertices), options.iterations + naive_start);
  // What would have been the better guess here is the likelier one in the next frame, and costs no solve.
  if (guesses) {
    pose.continues =
        misfit(guesses->continued, found.at.transforms) < misfit(guesses->turned, found.at.transforms);
  }
  pose.earlier = pose.rotations;
  scatter(patch, found.at, pose);
  pose.positions(handles, Eigen::all) = targets.positions;
  pose.targets = targets.positions;
  pose.lambda = lambda;
  pose.stretch = found.at.stretch;
  pose.converged = found.report.converged;
  pose.started = true;
  return found.report;
}

}  // namespace flexkey
