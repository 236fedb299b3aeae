#pragma once

#include "flexkey/timeline/shot.h"

namespace flexkey {

/// When a handle's keyed motions are played.
struct Playing {
  int repeat = 1;    // times, one after another; a time lasts from the handle's first key to its last
  double delay = 0;  // seconds by which they and the handle's waves and noises are later
};

/// From the first key of all keyed motions of a handle to the last, seconds; 0, 0 without keys.
Interval keyed_time(const Handle& handle);

/// Writes the keys of every time and the delay into the handle's tracks, so that nothing else has to know of
/// them. A time ends where the next begins: with another value there, the motion jumps.
void play_out(const Playing& playing, double fps, Handle& handle);

}  // namespace flexkey
