#include "flexkey/animate/solve_poses.h"

#include <algorithm>
#include <span>

#include "flexkey/animate/animate.h"
#include "flexkey/timeline/sampling.h"

namespace flexkey {
namespace {

constexpr int most_frames = 10;      // that a pose is held for, each of them the solver's iterations
constexpr std::size_t together = 5;  // poses that share a pass over the factor

void stand_still(Handle& handle) {
  handle.move.clear();
  handle.to.clear();
  handle.follow.reset();
  handle.rotate.clear();
  handle.euler.keys.clear();
  handle.scale.clear();
  handle.curve.clear();
  handle.layers.clear();
  handle.waves.clear();
  handle.noises.clear();
  handle.fade = 0;
  if (!handle.active.empty()) handle.active = {{-2, -1}};  // before the pose, which is at 0 and after
}

void lead(Handle& handle, const PosedHandle& pose) {
  handle.mirror.reset();
  handle.active.clear();
  handle.layers = {{{{0, pose.move, {}}}, {{0, pose.rotation, {}}}, {{0, pose.scale, {}}}}};
}

void hold_first(Track<double>& lambda) {
  lambda = {{0, sample_lambda(lambda, 0), {}}};
}

/// Some of the poses, held until all of them are converged.
std::vector<SolvedPose> solve_together(const Shot& shot, const Mesh& mesh, std::span<const PoseOutput> poses,
                                       const std::function<bool()>& stop) {
  std::vector<Shot> shots;
  std::vector<Scene> scenes;
  std::vector<SolvedPose> solved;
  for (const PoseOutput& pose : poses) {
    shots.push_back(posed(shot, pose));
    scenes.push_back(bind_shot(shots.back(), mesh));
    solved.push_back({pose.name, {}, {}});
  }
  std::vector<Take> takes;
  for (std::size_t k = 0; k < shots.size(); ++k) takes.push_back({shots[k], scenes[k]});
  AnimateHooks hooks;
  hooks.keep = Keep::nothing;
  hooks.on_wanted = [&](std::size_t k, const SolvedFrame& frame) {
    const int before = solved[k].report.solves;
    solved[k].positions = frame.positions;
    solved[k].report = frame.report;
    solved[k].report.frame = 0;
    solved[k].report.solves += before;
  };
  hooks.stop = [&] {
    return (stop && stop()) || std::all_of(solved.begin(), solved.end(),
                                           [](const SolvedPose& pose) { return pose.report.converged; });
  };
  animate(takes, mesh, {}, hooks);
  std::erase_if(solved, [](const SolvedPose& pose) { return pose.positions.rows() == 0; });
  return solved;
}

}  // namespace

Shot posed(const Shot& shot, const PoseOutput& pose) {
  Shot result = shot;
  for (Handle& handle : result.handles) {
    stand_still(handle);
    if (const auto led = pose.handles.find(handle.name); led != pose.handles.end()) lead(handle, led->second);
  }
  hold_first(result.lambda);
  for (LambdaRegion& region : result.regions) hold_first(region.lambda);
  result.duration = (most_frames - 1) / result.fps;
  result.loop = Loop::none;
  return result;
}

std::vector<SolvedPose> solve_poses(const Shot& shot, const Mesh& mesh, const std::function<bool()>& stop) {
  std::vector<SolvedPose> solved;
  for (std::span<const PoseOutput> left(shot.gltf.poses); !left.empty() && !(stop && stop());) {
    const std::span<const PoseOutput> batch = left.first(std::min(together, left.size()));
    left = left.subspan(batch.size());
    for (SolvedPose& pose : solve_together(shot, mesh, batch, stop)) solved.push_back(std::move(pose));
  }
  return solved;
}

}  // namespace flexkey
