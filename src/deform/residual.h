#pragma once

#include <Eigen/Core>

#include "flexkey/deform/cell_tables.h"
#include "flexkey/deform/local_step.h"

namespace flexkey {

/// r − L p on the rows, with r of eq 4, e_ij = p_i − p_j at rest and δ_i = Σ_j ω_ij e_ij:
/// r_i = λ_i Σ_j ω_ij/2 (R_i + R_j) e_ij + (1 − λ_i) S_i R_i δ_i.
/// With rims the rigid part is the sum of ω_ij^t (R_i + R_j + R_k)/3 e_ij over the triangles t = (i, j, k).
/// p: #patch x 3. lambda: at least #rows, in patch numbering. result: becomes rows x 3.
void residual(const CellTables& cells, const Positions& p, const Transforms& transforms,
              const Eigen::VectorXd& lambda, Positions& result);

/// L x on the vertices of F, (L x)_i = Σ_j ω_ij (x_i − x_j). x: rows x 3. result: becomes free x 3.
void free_laplacian(const CellTables& cells, const Positions& x, Positions& result);

}  // namespace flexkey
