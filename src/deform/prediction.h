#pragma once

#include <Eigen/Core>
#include <vector>

#include "flexkey/deform/local_step.h"
#include "flexkey/deform/patch.h"
#include "flexkey/deform/weights.h"

namespace flexkey {

/// How much of each handle's motion reaches a cell: harmonic over the surface, 1 on the handle and 0 on every
/// other fixed vertex, by the clamped L_ff. #fitted x #handles, a column a handle.
/// clamped: the surface's cells. owner: #V, the handle that leads a vertex, or -1.
Eigen::MatrixXd harmonic_weights(const Cells& clamped, const Patch& patch, const std::vector<int>& owner,
                                 int handle_count);

/// R_i turned by Q_i = exp(Σ_h w_h(i) θ_h), S_i kept. weights: #fitted x #handles. turns: #handles x 3, each
/// handle's world rotation vector since the last frame, radians; whole turns count.
Transforms turned(const Transforms& last, const Eigen::MatrixXd& weights, const Positions& turns);

/// R_i continued by its own last change, S_i kept: R_i R_earlierᵀ R_i.
Transforms continued(const Transforms& last, const std::vector<Eigen::Matrix3d>& earlier);

/// Σ ‖R_i − R_i found‖² over the cells: how far a prediction was off.
double misfit(const Transforms& predicted, const Transforms& found);

}  // namespace flexkey
