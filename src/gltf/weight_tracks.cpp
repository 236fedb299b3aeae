#include "flexkey/gltf/weight_tracks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

void add_key(WeightTrack& track, double time, const Eigen::RowVectorXf& weights) {
  track.times.push_back(time);
  track.weights.conservativeResize(track.weights.rows() + 1, weights.size());
  track.weights.bottomRows(1) = weights;
}

/// The keys' times, seconds from the clip's first frame.
std::vector<double> key_times(const Clip& clip, const Basis& basis) {
  std::vector<double> times;
  for (const double key : basis.keys) times.push_back((key - clip.reports.front().frame) / clip.fps);
  return times;
}

Eigen::RowVectorXf weights_at_second(const Clip& clip, const Basis& basis, double second) {
  return weights_at(basis, std::array{clip.reports.front().frame + second * clip.fps}).cast<float>();
}

/// from, to: seconds from the clip's first frame.
WeightTrack track_of(const Clip& clip, const Basis& basis, double from, double to) {
  WeightTrack track;
  add_key(track, 0, weights_at_second(clip, basis, from));
  const std::vector<double> times = key_times(clip, basis);
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (times[k] > from && times[k] < to)
      add_key(track, times[k] - from, basis.weights.row(static_cast<Eigen::Index>(k)));
  }
  if (to > from) add_key(track, to - from, weights_at_second(clip, basis, to));
  return track;
}

/// When the clip's first and last frames are, seconds of the shot.
double first_second(const Clip& clip) {
  return clip.reports.front().frame / clip.fps;
}
double last_second(const Clip& clip) {
  return (comes_round(clip) ? clip.period : clip.reports.back().frame) / clip.fps;
}

/// With a key at the end of a cycle that is the first once more, so that players go on without a jump.
Basis closed(const Clip& clip, const Basis& basis) {
  Basis round{{}, basis.keys, basis.weights, {}};
  if (!comes_round(clip)) return round;
  round.keys.push_back(clip.period);
  round.weights.conservativeResize(basis.weights.rows() + 1, Eigen::NoChange);
  round.weights.bottomRows(1) = basis.weights.topRows(1);
  return round;
}

WeightTrack track_of(const Clip& clip, const Basis& basis, const ClipRange& range) {
  const double first = first_second(clip), last = last_second(clip);
  const double from = std::max(range.from, first), to = std::min(range.to, last);
  if (from > to) {
    throw InputError(
        fmt::format("clip '{}' from {} s to {} s has no frame: those written go from {} s to {} s",
                    range.name, range.from, range.to, first, last));
  }
  WeightTrack track = track_of(clip, basis, from - first, to - first);
  track.name = range.name;
  track.from = from;
  track.to = to;
  return track;
}

WeightTrack whole_track(const Clip& clip, const Basis& basis) {
  return {clip.name, key_times(clip, basis), basis.weights, first_second(clip), last_second(clip)};
}

}  // namespace

std::vector<WeightTrack> weight_tracks(const Clip& clip, const Basis& basis,
                                       const std::vector<ClipRange>& ranges) {
  const Basis whole = closed(clip, basis);
  std::vector<WeightTrack> tracks;
  for (const ClipRange& range : ranges) tracks.push_back(track_of(clip, whole, range));
  if (ranges.empty()) tracks.push_back(whole_track(clip, whole));
  return tracks;
}

std::vector<WeightTrack> tracks_of(const Clip& clip, const Basis& basis, const GltfOptions& options) {
  std::vector<WeightTrack> tracks = weight_tracks(clip, basis, options.clips);
  if (options.clips.empty() && !options.animation.empty()) tracks.front().name = options.animation;
  return tracks;
}

}  // namespace flexkey
