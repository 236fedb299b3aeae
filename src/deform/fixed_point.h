#pragma once

#include <span>
#include <vector>

#include "flexkey/deform/anderson.h"
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
  Ties ties;
  LaplacianSystem system;
  double diagonal = 0;       // of the rest mesh's bounding box
  Eigen::MatrixXd harmonic;  // #fitted x #handles, see harmonic_weights; empty without prediction
};

/// Where an iteration is, in patch numbering, and what it goes towards.
struct Iterate {
  Positions positions;     // #patch x 3, the fixed vertices already at their targets
  Transforms transforms;   // fitted to positions, or predicted for the frame
  Eigen::VectorXd lambda;  // #patch
  Positions soft;          // #springs x 3, the frame's targets of the soft handles
  Anderson window;         // with what earlier frames left in it
  int most_solves = 0;
  int frame = 1;      // of the course, from 1
  double unseen = 0;  // what earlier frames were estimated to be off, as far as later looks have not paid
                      // it off, while too little is known of the slow directions to see it
};

struct FixedPoint {
  Iterate at;
  SolveReport report;
};

/// The local step: R_i and S_i of every fitted cell at the iterate's positions, R = T = Q in rigid regions.
void refit(const Problem& problem, Iterate& at);

/// Goes from each of `from` towards its fixed point of P -> solve(r(R(P), S(P)), c) in at most its
/// most_solves global steps; those of all are solved in one pass, and the answers are those of single runs.
/// An answer is always what a solve gave. It counts as converged when the estimated distance to the fixed
/// point that plain iteration would reach is within the tolerance: with acceleration what the mixture still
/// moves, and of what it cannot cancel κ times, κ = ‖ΔP‖/‖Δf‖ at its largest over the course, see
/// Anderson::stretch, and no less than a contraction by 0.98 λ promises, nor than 4; in the first frames a
/// part of what those before were off as well; without, the geometric series of the shrinking steps. Now and
/// then a frame goes on until it fills the window, as a few looks do not show κ. Throws DeformError if
/// positions leave the range of numbers.
std::vector<FixedPoint> iterate(const Problem& problem, std::vector<Iterate> from);

}  // namespace flexkey
