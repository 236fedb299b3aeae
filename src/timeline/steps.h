#pragma once

#include <optional>
#include <vector>

#include "flexkey/timeline/shot.h"

namespace flexkey {

// A shot is solved in steps, each from the one before, and its frames are made of them.
//   none:      step k is frame k.
//   cycle:     of N frames; two laps and one more step at the end of the second. Frame k is step N + k, so
//              that it has the past of a surface that comes round, and step 2N shows how far it is from
//              closing.
//   ping-pong: step k is frame k, and behind the last the frames are the steps backwards.

int step_count(const Shot& shot);

/// The step that a frame shows, and the first frame that a step shows: none on the first lap of a cycle.
int step_of(const Shot& shot, int frame);
std::optional<int> frame_of(const Shot& shot, int step);

/// How many steps must be solved for these frames; empty: for all of them, and for how well a cycle closes.
int steps_until(const Shot& shot, const std::vector<int>& frames);

/// The steps that these frames show, increasing; empty: all.
std::vector<int> steps_shown(const Shot& shot, const std::vector<int>& frames);

/// When a step or a frame is among the timeline's keys, seconds.
double time_of_step(const Shot& shot, int step);
double time_of_frame(const Shot& shot, int frame);

/// When the shot ends as it is played, seconds.
double played_duration(const Shot& shot);

}  // namespace flexkey
