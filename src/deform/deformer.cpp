#include "flexkey/deform/deformer.h"

#include <utility>

#include "flexkey/deform/checks.h"
#include "flexkey/deform/fixed_point.h"

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

Problem make_problem(const Mesh& rest, const Cells& cells, const std::vector<bool>& is_free,
                     const DeformOptions& options) {
  const Patch patch = make_patch(cells, rest.positions, is_free, options.system);
  return {options, patch, LaplacianSystem(patch, options.system), bounds_of(rest.positions).diagonal()};
}

Iterate gather(const Patch& patch, const Pose& pose) {
  Iterate at{pose.positions(patch.vertices, Eigen::all), {}};
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
  const Cells cells = build_cells(rest, options.weights);
  const std::vector<bool> is_free = free_vertices(constraints, cells);
  require_held(rest, cells, is_free);
  Problem problem = make_problem(rest, cells, is_free, options);
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
  at.transforms = local_step(problem.patch, at.positions, at.transforms, problem.options);
  scatter(problem.patch, at, pose);
  pose.converged = false;
  pose.started = true;
  return pose;
}

SolveReport Deformer::solve(const Positions& targets, double lambda, Pose& pose) const {
  return solve(targets, Eigen::VectorXd::Constant(state_->rest.rows(), lambda), pose);
}

SolveReport Deformer::solve(const Positions& targets, const Eigen::VectorXd& lambda, Pose& pose) const {
  const auto& [rest, handles, handle_places, problem] = *state_;
  const auto& [options, patch, system, diagonal] = problem;
  require_targets(targets, handles.size());
  require_lambda(lambda, rest.rows());
  require_pose(pose, rest.rows());
  if (answers(pose, targets, lambda)) {
    pose.started = true;
    return {0, 0, !options.fixed_count};
  }
  Iterate from = gather(patch, pose);
  for (std::size_t h = 0; h < handles.size(); ++h) {
    if (handle_places[h] >= 0) from.positions.row(handle_places[h]) = targets.row(h);
  }
  // From rest, R = S = 1 makes the first solve the naive Laplacian one that the paper starts from.
  const int naive_start = options.fixed_count && !pose.started ? 1 : 0;
  const FixedPoint found =
      iterate(problem, std::move(from), lambda(patch.vertices), options.iterations + naive_start);
  scatter(patch, found.at, pose);
  pose.positions(handles, Eigen::all) = targets;
  pose.targets = targets;
  pose.lambda = lambda;
  pose.converged = found.report.converged;
  pose.started = true;
  return found.report;
}

}  // namespace flexkey
