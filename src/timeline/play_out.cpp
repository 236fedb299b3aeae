#include "flexkey/timeline/play_out.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "flexkey/timeline/scalar.h"

namespace flexkey {
namespace {

/// handle: a Handle or a const one.
template <class AnyHandle, class Visit>
void for_each_track(AnyHandle& handle, const Visit& visit) {
  visit(handle.move);
  visit(handle.to);
  visit(handle.rotate);
  visit(handle.euler.keys);
  visit(handle.scale);
  visit(handle.curve);
  if (handle.follow) visit(handle.follow->shares);
  for (auto& layer : handle.layers) {
    visit(layer.move);
    visit(layer.rotate);
    visit(layer.scale);
  }
}

/// The track played `times` times over the handle's keyed time, what is outside its own keys held.
template <class Value>
Track<Value> repeated(const Track<Value>& track, const Interval& time, int times) {
  Track<Value> played;
  const Easing hold{Easing::Kind::hold};
  for (int n = 0; n < times; ++n) {
    const double offset = n * (time.to - time.from);
    if (n > 0) played.back().ease = hold;
    if (n > 0 && track.front().time > time.from)
      played.push_back({time.from + offset, track.front().value, hold});
    for (const Key<Value>& key : track) played.push_back({key.time + offset, key.value, key.ease});
  }
  return played;
}

}  // namespace

Interval keyed_time(const Handle& handle) {
  Interval time{std::numeric_limits<double>::infinity(), 0};
  for_each_track(handle, [&](const auto& track) {
    if (track.empty()) return;
    time.from = std::min(time.from, track.front().time);
    time.to = std::max(time.to, track.back().time);
  });
  return time.from <= time.to ? time : Interval{};
}

void play_out(const Playing& playing, double fps, Handle& handle) {
  const Interval time = keyed_time(handle);
  for_each_track(handle, [&](auto& track) {
    if (track.empty()) return;
    if (playing.repeat > 1) track = repeated(track, time, playing.repeat);
    for (auto& key : track) key.time = snapped_to_frame(key.time + playing.delay, fps);
  });
  for (Wave& wave : handle.waves) wave.phase -= 2 * std::numbers::pi * wave.frequency * playing.delay;
  for (Noise& noise : handle.noises) noise.delay = playing.delay;
  if (handle.mirror) handle.mirror->delay = playing.delay;
}

}  // namespace flexkey
