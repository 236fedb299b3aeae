#pragma once

#include "flexkey/deform/cell_tables.h"
#include "flexkey/deform/deformer.h"
#include "flexkey/deform/local_step.h"
#include "flexkey/deform/system.h"

namespace flexkey {

/// Everything that stays from frame to frame.
struct Problem {
  DeformOptions options;
  Patch patch;
  CellTables cells;
  LaplacianSystem system;
  double diagonal = 0;       // of the rest mesh's bounding box
  Eigen::MatrixXd harmonic;  // #fitted x #handles, see harmonic_weights; empty without prediction
};

/// Where the iteration is, in patch numbering.
struct Iterate {
  Positions positions;    // #patch x 3
  Transforms transforms;  // fitted to positions, or predicted for the frame
  double stretch = 0;  // κ as last measured: how much farther the fixed point may be than a step; 0: unknown
};

struct FixedPoint {
  Iterate at;
  SolveReport report;
};

/// Goes from `from` towards the fixed point of P -> solve(r(R(P), S(P)), c) in at most `solves` global steps.
/// The answer is always what a solve gave. It counts as converged when the estimated distance to the fixed
/// point that plain iteration would reach is within the tolerance: κ times the step, κ = max(1, ‖ΔP‖/‖Δf‖),
/// and the jump of the mixture; or without acceleration the geometric series that the steps' shrinking
/// promises. from: the fixed vertices already at their targets. lambda: #patch. Throws DeformError if the
/// positions leave the range of numbers.
FixedPoint iterate(const Problem& problem, Iterate from, const Eigen::VectorXd& lambda, int solves);

}  // namespace flexkey
