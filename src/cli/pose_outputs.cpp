#include "cli/pose_outputs.h"

#include <algorithm>
#include <utility>

#include "cli/interrupt.h"
#include "cli/stopwatch.h"
#include "flexkey/animate/solve_poses.h"

namespace flexkey::cli {

void check_pose_outputs(const LoadedShot& loaded, const ShotOptions& options) {
  const Shot& shot = loaded.shot;
  const bool always_the_same = std::all_of(shot.handles.begin(), shot.handles.end(),
                                           [](const Handle& handle) { return handle.active.empty(); });
  if (always_the_same) return;  // what holds the shot holds each pose
  for (const PoseOutput& pose : shot.gltf.poses) bind_loaded(posed(shot, pose), loaded, options);
}

std::vector<PoseShape> solve_pose_shapes(const Session& session, const Shot& run, RunReport& report) {
  if (run.gltf.poses.empty()) return {};
  const Stopwatch watch;
  std::vector<PoseShape> shapes;
  for (SolvedPose& pose : solve_poses(run, session.loaded.mesh, [] { return noted_signal() != 0; })) {
    report.poses.push_back({pose.name, pose.report});
    shapes.push_back({std::move(pose.name), std::move(pose.positions)});
  }
  report.pose_seconds = watch.seconds();
  return shapes;
}

}  // namespace flexkey::cli
