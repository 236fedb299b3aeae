#pragma once

#include <Eigen/Core>
#include <vector>

#include "flexkey/deform/cell_tables.h"
#include "flexkey/deform/options.h"

namespace flexkey {

/// T_i = S_i R_i of the patch's fitted cells.
struct Transforms {
  std::vector<Eigen::Matrix3d> rotations;  // #fitted, R_i
  Positions scales;                        // #fitted x 3, the diagonal of S_i in world axes
};

/// The local step: R_i and S_i of every fitted cell at these positions.
/// positions: #patch x 3. transforms: the previous ones, replaced by the new; where R_i is not unique it is
/// the one nearest the previous.
void local_step(const CellTables& cells, const DeformOptions& options, const Positions& positions,
                Transforms& transforms);

}  // namespace flexkey
