#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "flexkey/timeline/easing.h"
#include "flexkey/timeline/track.h"

namespace flexkey {

/// Where a time falls among the keys. from == to: at that key, or held before the first or after the last.
struct Stretch {
  std::size_t from = 0, to = 0;
  double share = 0;  // of the time between the keys, in (0, 1)
};

template <class Value>
Stretch find_stretch(const Track<Value>& track, double time) {
  const auto after = std::upper_bound(track.begin(), track.end(), time,
                                      [](double t, const Key<Value>& key) { return t < key.time; });
  if (after == track.begin()) return {0, 0, 0};
  const auto to = static_cast<std::size_t>(std::distance(track.begin(), after));
  const std::size_t from = to - 1;
  if (after == track.end() || time == track[from].time) return {from, from, 0};
  return {from, to, (time - track[from].time) / (track[to].time - track[from].time)};
}

/// The cubic with values a, b and slopes p, q (a stretch) at its ends, at share s.
template <class Value>
Value hermite(const Value& a, const Value& b, const Value& p, const Value& q, double s) {
  const double r = 1 - s;
  return (r * r * (1 + 2 * s)) * a + (s * s * (3 - 2 * s)) * b + (r * r * s) * p - (s * s * r) * q;
}

/// Catmull-Rom slope at key i, a second: (v_{i+1} − v_{i−1}) / (t_{i+1} − t_{i−1}); 0 at the first and the
/// last key, where the value is held outside.
template <class Value, class KeyValue, class At>
Value catmull_rom_slope(const Track<KeyValue>& track, const At& at, std::size_t i) {
  if (i == 0 || i + 1 == track.size()) return 0.0 * at(i);
  return (at(i + 1) - at(i - 1)) / (track[i + 1].time - track[i - 1].time);
}

/// The track's value at a time; at a key, that key's to the bit. at(i): the value of key i in a vector space.
/// slope(i): its slope there, for `smooth`.
template <class Value, class KeyValue, class At, class Slope>
Value interpolate(const Track<KeyValue>& track, double time, const At& at, const Slope& slope) {
  const auto [from, to, share] = find_stretch(track, time);
  if (from == to) return at(from);
  const Value a = at(from);
  const Easing& ease = track[from].ease;
  if (ease.kind == Easing::Kind::hold) return a;
  const Value b = at(to);
  if (ease.kind != Easing::Kind::smooth) return a + eased(ease, share) * (b - a);
  const double duration = track[to].time - track[from].time;
  const Value p = duration * slope(from), q = duration * slope(to);
  return hermite<Value>(a, b, p, q, share);
}

template <class Value, class KeyValue, class At>
Value interpolate(const Track<KeyValue>& track, double time, const At& at) {
  const auto slope = [&](std::size_t i) { return catmull_rom_slope<Value>(track, at, i); };
  return interpolate<Value>(track, time, at, slope);
}

}  // namespace flexkey
