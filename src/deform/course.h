#pragma once

#include "flexkey/deform/anderson.h"
#include "flexkey/mesh/types.h"

namespace flexkey {

/// Less than all of a deviation is expected to come again, as what is continued in full drifts: the slow
/// directions of λ = 1 hardly pull a frame back.
constexpr double most_recurrence = 0.9;

/// How a pose came about, in patch numbering: what the next frame's start, its estimate and the detection of
/// slip go by.
struct Course {
  Positions deviations{0, 3};  // #fitted x 3, by which the last frame turned beyond its handles' turns
  double recurrence = most_recurrence;  // the share of such deviations that comes again in the next frame
  double pace = 0;                      // ‖Δ targets‖ of the last frame
  Anderson window;                      // the last differences of iterates
  int frames = 0;                       // solved so far, see Iterate
  double unseen = 0;                    // see Iterate
  Positions winding{0, 3};              // #fitted x 3, the rotation vectors of each cell's frames added up
  Positions handle_winding{0, 3};       // #handles x 3, likewise of the handles' turns
  bool slipped = false;                 // see has_slipped
};

template <MaybeConst<Course> Self>
auto members_of(Self& course) {
  auto& [deviations, recurrence, pace, window, frames, unseen, winding, handle_winding, slipped] = course;
  return std::tie(deviations, recurrence, pace, window, frames, unseen, winding, handle_winding, slipped);
}

}  // namespace flexkey
