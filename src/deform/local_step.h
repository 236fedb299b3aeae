#pragma once

#include <Eigen/Core>
#include <vector>

#include "flexkey/deform/options.h"
#include "flexkey/deform/patch.h"

namespace flexkey {

/// T_i = S_i R_i of the patch's fitted cells.
struct Transforms {
  std::vector<Eigen::Matrix3d> rotations;  // #fitted, R_i
  Positions scales;                        // #fitted x 3, the diagonal of S_i in world axes
};

/// S_i for a cell with A = Σ ω e′ eᵀ, C = Σ ω e eᵀ and R = R_i. `axis` is eq 8's minimum, each s_k drawn by
/// epsilon towards the one number that fits best, `uniform` is that number, `none` is 1. A number that the
/// cell does not determine (its denominator under 1e-12 of Σ ω |e|²) is 1.
Vec3 best_scale(const Eigen::Matrix3d& A, const Eigen::Matrix3d& C, const Eigen::Matrix3d& R,
                const DeformOptions& options);

/// The local step: R_i and S_i of every fitted cell at these positions.
/// positions: #patch x 3. previous: where R_i is not unique it is the one nearest the previous.
Transforms local_step(const Patch& patch, const Positions& positions, const Transforms& previous,
                      const DeformOptions& options);

}  // namespace flexkey
