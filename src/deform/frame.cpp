#include "flexkey/deform/frame.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

#include "flexkey/deform/prediction.h"
#include "flexkey/deform/slip.h"

namespace flexkey {
namespace {

/// How much faster the targets move than a frame ago.
double quickening(double pace, double pace_before) {
  constexpr double most = 1.5;  // little is known of what is far from the last frame
  return pace_before > 0 ? std::min(most, pace / pace_before) : 0;
}

void wind(const Problem& problem, const Positions& handle_turns, const Positions& turns, Course& course) {
  if (handle_turns.rows() == 0) return;
  if (course.winding.rows() == 0) {
    course.winding = Positions::Zero(turns.rows(), 3);
    course.handle_winding = Positions::Zero(handle_turns.rows(), 3);
  }
  course.winding += turns + course.deviations;
  course.handle_winding += handle_turns;
  course.slipped = has_slipped(problem.patch.cells, course);
}

Transforms gather_transforms(const Patch& patch, const Pose& pose) {
  Transforms transforms{std::vector<Eigen::Matrix3d>(patch.fitted), Positions(patch.fitted, 3)};
  tbb::parallel_for(0, patch.fitted, [&](int i) {
    transforms.rotations[i] = pose.rotations[patch.vertices[i]];
    transforms.scales.row(i) = pose.scales.row(patch.vertices[i]);
  });
  return transforms;
}

}  // namespace

Prediction predict(const Problem& problem, const Pose& pose, const Targets& targets) {
  Prediction prediction;
  prediction.turned = gather_transforms(problem.patch, pose);
  if (!problem.options.predict) return prediction;
  if (targets.turns.rows() > 0) {
    prediction.turns = problem.harmonic * targets.turns;
    prediction.turned = turned_further(prediction.turned, prediction.turns);
  }
  prediction.expected = Positions::Zero(problem.patch.fitted, 3);
  prediction.pace = (targets.positions - pose.targets).norm();
  if (pose.course.deviations.rows() > 0)
    prediction.expected = quickening(prediction.pace, pose.course.pace) * pose.course.deviations;
  return prediction;
}

Iterate gather(const Patch& patch, const Pose& pose) {
  Iterate at;
  at.positions = pose.positions(patch.vertices, Eigen::all);
  at.transforms = gather_transforms(patch, pose);
  return at;
}

void scatter(const Patch& patch, const Iterate& at, Pose& pose) {
  tbb::parallel_for(0, patch.fitted, [&](int i) {
    const int v = patch.vertices[i];
    if (i < patch.free) pose.positions.row(v) = at.positions.row(i);
    pose.rotations[v] = at.transforms.rotations[i];
    pose.scales.row(v) = at.transforms.scales.row(i);
  });
}

Iterate start(const Problem& problem, Pose& pose, const Prediction& prediction) {
  const DeformOptions& options = problem.options;
  Iterate from;
  from.positions = pose.positions(problem.patch.vertices, Eigen::all);
  const bool is_carried_on = options.predict && pose.course.deviations.rows() > 0;
  from.transforms = is_carried_on
                        ? turned_further(prediction.turned, pose.course.recurrence * prediction.expected)
                        : prediction.turned;
  from.window = std::exchange(pose.course.window, {});
  from.frame = ++pose.course.frames;
  from.unseen = pose.course.unseen;
  // From rest, R = S = 1 makes the first solve the naive Laplacian one that the paper starts from.
  const int naive_start = options.fixed_count && !pose.started ? 1 : 0;
  from.most_solves = options.iterations + naive_start;
  return from;
}

void finish(const Problem& problem, const Frame& frame, const Prediction& prediction, FixedPoint& found,
            Pose& pose) {
  Course& course = pose.course;
  if (problem.options.predict) {
    course.deviations = deviations(found.at.transforms, prediction.turned);
    course.recurrence = recurrence(course.deviations, prediction.expected);
    course.pace = prediction.pace;
    wind(problem, frame.targets.turns, prediction.turns, course);
  }
  course.window = std::move(found.at.window);
  course.unseen = found.at.unseen;
  found.report.slipped = course.slipped;
  scatter(problem.patch, found.at, pose);
  pose.targets = frame.targets.positions;
  pose.lambda = frame.lambda;
  pose.converged = found.report.converged;
}

}  // namespace flexkey
