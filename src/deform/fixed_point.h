#pragma once

#include "flexkey/deform/deformer.h"
#include "flexkey/deform/local_step.h"
#include "flexkey/deform/system.h"

namespace flexkey {

/// Everything that stays from frame to frame.
struct Problem {
  DeformOptions options;
  Patch patch;
  LaplacianSystem system;
  double diagonal = 0;  // of the rest mesh's bounding box
};

/// Where the iteration is, in patch numbering.
struct Iterate {
  Positions positions;    // #patch x 3
  Transforms transforms;  // fitted to positions
};

struct FixedPoint {
  Iterate at;
  SolveReport report;
};

/// Goes from `from` towards the fixed point of P -> solve(r(R(P), S(P)), c) in at most `solves` global steps.
/// from: the fixed vertices already at their targets, the transforms those of the frame before.
/// lambda: #patch. Throws DeformError if the positions leave the range of numbers.
FixedPoint iterate(const Problem& problem, Iterate from, const Eigen::VectorXd& lambda, int solves);

}  // namespace flexkey
