#include "flexkey/gltf/sampler_track.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace flexkey {
namespace {

/// Key whose time is the last at or before `time`; 0 before the first.
Eigen::Index key_before(const FloatRows& times, float time) {
  const float* const end = times.data() + times.rows();
  const auto after = std::upper_bound(times.data(), end, time) - times.data();
  return std::max<Eigen::Index>(after - 1, 0);
}

/// Cubic Hermite curve between two keys, glTF 2.0 appendix C.5; t in 0..1 of `duration` seconds.
Eigen::RowVectorXf cubic(const SamplerTrack& track, Eigen::Index key, float t, float duration) {
  const auto value = [&](Eigen::Index of) { return track.values.row(3 * of + 1); };
  const Eigen::RowVectorXf out_tangent = duration * track.values.row(3 * key + 2);
  const Eigen::RowVectorXf in_tangent = duration * track.values.row(3 * (key + 1));
  const float t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * value(key) + (t3 - 2 * t2 + t) * out_tangent +
         (3 * t2 - 2 * t3) * value(key + 1) + (t3 - t2) * in_tangent;
}

}  // namespace

SamplerTrack padded(const SamplerTrack& track, Eigen::Index count) {
  SamplerTrack result = track;
  result.values = FloatRows::Zero(track.values.rows(), track.values.cols() + count);
  result.values.leftCols(track.values.cols()) = track.values;
  return result;
}

Eigen::RowVectorXf sample(const SamplerTrack& track, float time) {
  const bool is_cubic = track.interpolation == "CUBICSPLINE";
  const auto value = [&](Eigen::Index key) { return track.values.row(is_cubic ? 3 * key + 1 : key); };
  const Eigen::Index key = key_before(track.times, time), last = track.times.rows() - 1;
  if (key == last || time <= track.times(0, 0) || track.interpolation == "STEP") return value(key);
  const float duration = track.times(key + 1, 0) - track.times(key, 0);
  const float t = duration > 0 ? (time - track.times(key, 0)) / duration : 0;
  if (is_cubic) return cubic(track, key, t, duration);
  return (1 - t) * value(key) + t * value(key + 1);
}

SamplerTrack side_by_side(const SamplerTrack& first, const SamplerTrack& second) {
  std::set<float> times(first.times.data(), first.times.data() + first.times.rows());
  if (first.interpolation == "STEP") {
    const std::set<float> steps = times;
    for (const float time : steps)
      if (time > 0) times.insert(std::nextafter(time, 0.0F));
  }
  times.insert(second.times.data(), second.times.data() + second.times.rows());

  SamplerTrack result;
  result.times.resize(static_cast<Eigen::Index>(times.size()), 1);
  result.values.resize(result.times.rows(), first.values.cols() + second.values.cols());
  Eigen::Index row = 0;
  for (const float time : times) {
    result.times(row, 0) = time;
    result.values.row(row) << sample(first, time), sample(second, time);
    ++row;
  }
  return result;
}

}  // namespace flexkey
