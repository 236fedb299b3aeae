#pragma once

#include "flexkey/deform/local_step.h"
#include "flexkey/deform/patch.h"

namespace flexkey {

/// r of eq 4 with e_ij = p_i − p_j at rest and δ_i = Σ_j ω_ij e_ij, rows x 3:
/// r_i = λ_i Σ_j ω_ij/2 (R_i + R_j) e_ij + (1 − λ_i) S_i R_i δ_i.
/// lambda: at least #rows, in patch numbering.
Positions right_hand_side(const Patch& patch, const Transforms& transforms, const Eigen::VectorXd& lambda);

}  // namespace flexkey
