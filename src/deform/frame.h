#pragma once

#include "flexkey/deform/deformer.h"
#include "flexkey/deform/fixed_point.h"

namespace flexkey {

/// What a frame's rotations are expected to be before its first solve.
struct Prediction {
  Transforms turned;         // by the handles' turns, spread over the surface
  Positions expected{0, 3};  // #fitted x 3, the deviations beyond it: those of the last frame, quickened
  Positions turns{0, 3};     // #fitted x 3, the handles' turns spread over the surface; empty: none is known
  double pace = 0;           // ‖Δ targets‖
};

/// Without `predict` the frame starts from the last one's R_i and S_i as they are.
Prediction predict(const Problem& problem, const Pose& pose, const Targets& targets);

/// A pose in patch numbering.
Iterate gather(const Patch& patch, const Pose& pose);
void scatter(const Patch& patch, const Iterate& at, Pose& pose);

/// Where the iteration of a frame starts, its targets and λ left to fill in. The pose's window goes along.
Iterate start(const Problem& problem, Pose& pose, const Prediction& prediction);

/// Makes what was found the pose, and adds the frame to the course that leads there. The report learns of
/// slip.
void finish(const Problem& problem, const Frame& frame, const Prediction& prediction, FixedPoint& found,
            Pose& pose);

}  // namespace flexkey
