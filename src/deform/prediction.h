#pragma once

#include <Eigen/Core>
#include <vector>

#include "flexkey/deform/factor.h"
#include "flexkey/deform/local_step.h"
#include "flexkey/deform/patch.h"
#include "flexkey/deform/ties.h"
#include "flexkey/deform/weights.h"

namespace flexkey {

/// How much of each handle's motion reaches a cell: harmonic over the surface, 1 on the handle and 0 on every
/// other fixed vertex, by the clamped L_ff with a spring to every vertex of a soft handle, so that the
/// weights of all handles sum to 1 where nothing else holds the surface. A rigid region has one weight.
/// #fitted x #handles, a column a handle. clamped: the surface's cells. owner: #V, the handle that leads a
/// vertex, or -1. factor: of that L_ff, where it is there already.
Eigen::MatrixXd harmonic_weights(const Cells& clamped, const Patch& patch, const std::vector<int>& owner,
                                 int handle_count, const Ties& ties = {}, const Factor* factor = nullptr);

/// By how much R_i turned beyond a prediction, #fitted x 3: the rotation vectors of R_i found R_iᵀ predicted.
Positions deviations(const Transforms& found, const Transforms& predicted);

/// R_i turned further by exp of its vector, S_i kept. vectors: #fitted x 3, world, radians; Σ_h w_h(i) θ_h of
/// the handles' rotation vectors since the last frame counts whole turns.
Transforms turned_further(const Transforms& transforms, const Positions& vectors);

/// What share of the expected deviations came, by least squares, within 0 .. most_recurrence.
double recurrence(const Positions& found, const Positions& expected);

}  // namespace flexkey
