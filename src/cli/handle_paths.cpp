#include "cli/handle_paths.h"

#include <algorithm>

#include "flexkey/animate/handle_states.h"

namespace flexkey::cli {
namespace {

/// Adds the times of a track's keys.
template <class Value>
void add_times(std::vector<double>& times, const Track<Value>& track) {
  for (const Key<Value>& key : track) times.push_back(key.time);
}

}  // namespace

Positions path_of(const Scene& scene, int handle, const std::vector<double>& times) {
  Positions path(static_cast<Eigen::Index>(times.size()), 3);
  for (std::size_t k = 0; k < times.size(); ++k)
    path.row(static_cast<Eigen::Index>(k)) =
        targets_of(scene, sample_states(scene, times[k]), handle).colwise().mean();
  return path;
}

double reach_of(const Scene& scene, int handle, const std::vector<double>& times) {
  const SceneHandle& bound = scene.handles[static_cast<std::size_t>(handle)];
  if (bound.handle.is_anchor()) return 0;
  double reach = 0;
  for (const double time : times) {
    const Positions offsets = targets_of(scene, sample_states(scene, time), handle) - bound.rest;
    reach = std::max(reach, offsets.rowwise().norm().maxCoeff());
  }
  return reach;
}

std::vector<double> moments_to_look_at(const Shot& shot) {
  constexpr int most = 200;
  const int count = std::clamp(shot.frame_count(), 2, most);
  std::vector<double> times;
  for (int k = 0; k < count; ++k) times.push_back(shot.duration * k / (count - 1));
  return times;
}

std::vector<double> key_times(const Handle& handle) {
  std::vector<double> times;
  add_times(times, handle.move);
  add_times(times, handle.to);
  add_times(times, handle.rotate);
  add_times(times, handle.euler.keys);
  add_times(times, handle.scale);
  add_times(times, handle.curve);
  if (handle.follow) add_times(times, handle.follow->shares);
  for (const MotionTracks& layer : handle.layers) {
    add_times(times, layer.move);
    add_times(times, layer.rotate);
    add_times(times, layer.scale);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace flexkey::cli
