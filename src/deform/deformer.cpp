#include "flexkey/deform/deformer.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

#include "flexkey/deform/checks.h"
#include "flexkey/deform/frame.h"
#include "flexkey/deform/prediction.h"
#include "flexkey/deform/rims.h"
#include "flexkey/deform/soft.h"
#include "flexkey/deform/vertex_areas.h"

namespace flexkey {

namespace {

/// The unknowns: the region without its handles. A vertex of no triangle has no equation and stays at rest.
std::vector<bool> free_vertices(const Constraints& constraints, const Cells& cells) {
  std::vector<bool> is_free(cells.count(), constraints.region.empty());
  for (const int v : constraints.region) is_free[v] = true;
  for (std::size_t k = 0; k < constraints.handles.size(); ++k) {
    if (strength_of(constraints, owner_of(constraints, k)) == 1) is_free[constraints.handles[k]] = false;
  }
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

/// #V, the rigid region that each vertex is in, or -1.
std::vector<int> bodies(const Constraints& constraints, int vertex_count) {
  std::vector<int> body(vertex_count, -1);
  for (std::size_t r = 0; r < constraints.rigid.size(); ++r) {
    for (const int v : constraints.rigid[r]) body[v] = static_cast<int>(r);
  }
  return body;
}

/// Without the softly held ones.
std::vector<bool> loose_vertices(std::vector<bool> is_free, const Constraints& constraints) {
  for (const int v : constraints.handles) is_free[v] = false;
  return is_free;
}

/// Each handle vertex's place in the patch, or -1 where no equation reads it.
std::vector<int> places_in(const Patch& patch, const std::vector<int>& handles, Eigen::Index vertex_count) {
  std::vector<int> place(static_cast<std::size_t>(vertex_count), -1);
  for (int i = 0; i < patch.vertex_count(); ++i) place[patch.vertices[i]] = i;
  std::vector<int> places;
  for (const int v : handles) places.push_back(place[v]);
  return places;
}

/// How each handle's turn spreads over the patch, #fitted x #handles.
Eigen::MatrixXd turn_weights(const Mesh& rest, const Cells& cells, const Constraints& constraints,
                             const Problem& problem) {
  std::vector<int> owner(rest.vertex_count(), -1);
  int handle_count = 0;
  for (std::size_t k = 0; k < constraints.handles.size(); ++k) {
    const int handle = owner_of(constraints, k);
    owner[constraints.handles[k]] = handle;
    handle_count = std::max(handle_count, handle + 1);
  }
  const Weights weights = problem.options.weights;
  const bool is_held = weights == Weights::clamped || weights == Weights::intrinsic_delaunay;
  const bool is_same_matrix = is_held && problem.options.system == System::direct;
  return harmonic_weights(is_held ? cells : build_cells(rest, Weights::clamped), problem.patch, owner,
                          handle_count, problem.ties,
                          is_same_matrix ? problem.system.plain_factor() : nullptr);
}

/// The places of the vertices of F alone.
std::vector<int> restricted(const std::vector<int>& order, const Patch& patch) {
  std::vector<int> places;
  for (int i = 0; i < patch.free && !order.empty(); ++i) places.push_back(order[patch.vertices[i]]);
  return places;
}

Problem make_problem(const Mesh& rest, const Constraints& constraints, const DeformOptions& options,
                     const std::vector<int>& order) {
  const Cells cells = build_cells(rest, options.weights);
  const std::vector<bool> is_free = free_vertices(constraints, cells);
  require_held(rest, cells, loose_vertices(is_free, constraints), constraints.rigid);
  Patch patch = make_patch(cells, rest.positions, is_free, options.system);
  const std::vector<int> body = bodies(constraints, rest.vertex_count());
  const std::vector<int> places = places_in(patch, constraints.handles, rest.vertex_count());
  Ties ties{soft_handles(constraints, places, patch.free), rigid_regions(body, patch),
            restricted(order, patch)};
  CellTables tables = tabulate(patch);
  if (options.cell == Cell::spokes_and_rims) add_rims(build_triangles(rest, options.weights), patch, tables);
  Eigen::VectorXd rows_by_area;
  if (options.area_weighting) rows_by_area = row_weights(rest)(patch.vertices);
  LaplacianSystem system(patch, options.system, ties, rows_by_area);
  Problem problem{options,
                  std::move(patch),
                  std::move(tables),
                  std::move(ties),
                  std::move(system),
                  bounds_of(rest.positions).diagonal(),
                  {}};
  if (options.predict) problem.harmonic = turn_weights(rest, cells, constraints, problem);
  return problem;
}

}  // namespace

struct Deformer::State {
  Positions rest;                  // #V x 3
  std::vector<int> handles;        // mesh vertices, in the order of the targets
  std::vector<int> handle_places;  // of each handle vertex in the patch, or -1
  Problem problem;
};

Deformer::Deformer(const Mesh& rest, const Constraints& constraints, const DeformOptions& options,
                   const std::vector<int>& order) {
  require_sound(options);
  require_sound(rest);
  require_sound(constraints, rest.vertex_count());
  require_order(order, rest.vertex_count());
  Problem problem = make_problem(rest, constraints, options, order);
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

namespace {

/// The pose as a start: R_i and S_i fitted to its positions, and an answer to nothing yet.
Pose fitted(const Problem& problem, Pose pose) {
  Iterate at = gather(problem.patch, pose);
  refit(problem, at);
  scatter(problem.patch, at, pose);
  pose.converged = false;
  return pose;
}

}  // namespace

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
  pose.started = true;
  return fitted(problem, std::move(pose));
}

Pose Deformer::adopt(const Pose& pose) const {
  require_pose(pose, state_->rest.rows());
  Pose start = rest_pose();
  start.positions = pose.positions;
  start.rotations = pose.rotations;
  start.scales = pose.scales;
  start.targets = pose.positions(state_->handles, Eigen::all);
  start.started = pose.started;
  return fitted(state_->problem, std::move(start));
}

bool Deformer::could_have_solved(const Pose& pose) const {
  const auto& [rest, handles, handle_places, problem] = *state_;
  const auto none_or = [](const auto& matrix, Eigen::Index rows) {
    return matrix.rows() == 0 || matrix.rows() == rows;
  };
  const Course& course = pose.course;
  return pose.positions.rows() == rest.rows() && pose.scales.rows() == rest.rows() &&
         static_cast<Eigen::Index>(pose.rotations.size()) == rest.rows() &&
         none_or(pose.lambda, rest.rows()) &&
         pose.targets.rows() == static_cast<Eigen::Index>(handles.size()) &&
         none_or(course.deviations, problem.patch.fitted) && none_or(course.winding, problem.patch.fitted) &&
         course.handle_winding.rows() == (course.winding.rows() == 0 ? 0 : problem.harmonic.cols()) &&
         course.window.fits(problem.patch.free);
}

std::size_t Deformer::bytes() const {
  const auto& [rest, handles, handle_places, problem] = *state_;
  constexpr std::size_t edge =
      sizeof(CellEdge) + sizeof(int) + 4 * sizeof(double);  // in Cells and CellTables
  constexpr std::size_t number = sizeof(double);
  const auto cells = static_cast<std::size_t>(problem.patch.fitted);
  return problem.system.bytes() + edge * problem.patch.cells.edges.size() + 11 * number * cells +
         number * static_cast<std::size_t>(problem.harmonic.size() + rest.size());
}

SolveReport Deformer::solve(const Targets& targets, double lambda, Pose& pose) const {
  return solve(targets, Eigen::VectorXd::Constant(state_->rest.rows(), lambda), pose);
}

SolveReport Deformer::solve(const Targets& targets, const Eigen::VectorXd& lambda, Pose& pose) const {
  const Frame frame{targets, lambda};
  return solve({&frame, 1}, {&pose, 1}).front();
}

std::vector<SolveReport> Deformer::solve(std::span<const Frame> frames, std::span<Pose> poses) const {
  const auto& [rest, handles, handle_places, problem] = *state_;
  require_batch(frames.size(), poses.size());
  std::vector<SolveReport> reports(frames.size());
  std::vector<std::size_t> places;  // of those to solve
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const auto& [targets, lambda] = frames[k];
    require_targets(targets.positions, handles.size());
    require_turns(targets.turns, problem.harmonic.cols(), problem.options.predict);
    require_lambda(lambda, rest.rows());
    require_pose(poses[k], rest.rows());
    if (!answers(poses[k], targets.positions, lambda)) places.push_back(k);
  }
  std::vector<Prediction> predictions(places.size());
  std::vector<Iterate> starts(places.size());
  tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t n) {
    const auto& [targets, lambda] = frames[places[n]];
    predictions[n] = predict(problem, poses[places[n]], targets);
    Iterate& from = starts[n] = start(problem, poses[places[n]], predictions[n]);
    from.lambda = lambda(problem.patch.vertices);
    from.soft = targets.positions(problem.system.springs().targets, Eigen::all);
    for (std::size_t h = 0; h < handles.size(); ++h)
      if (handle_places[h] >= problem.patch.free)
        from.positions.row(handle_places[h]) = targets.positions.row(h);
  });
  std::vector<FixedPoint> found = iterate(problem, std::move(starts));
  for (std::size_t k = 0; k < frames.size(); ++k) {
    poses[k].started = true;
    reports[k] = {.converged = !problem.options.fixed_count, .slipped = poses[k].course.slipped};
  }
  tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t n) {
    Pose& pose = poses[places[n]];
    pose.positions(handles, Eigen::all) = frames[places[n]].targets.positions;
    // The soft handles are among what is free.
    finish(problem, frames[places[n]], predictions[n], found[n], pose);
    reports[places[n]] = found[n].report;
  });
  return reports;
}

}  // namespace flexkey
