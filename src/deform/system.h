#pragma once

#include <Eigen/SparseCore>
#include <span>

#include "flexkey/deform/cell_tables.h"
#include "flexkey/deform/factor.h"
#include "flexkey/deform/options.h"
#include "flexkey/deform/patch.h"

namespace flexkey {

/// The global step: the p′ that meets the fixed vertices exactly and solves the rest of eq 7 (least squares
/// over all rows, each scaled by the root of its weight) or of eq 5 (`direct`: the rows of F,
/// L_ff p′_f = r_f − L_fc c). Factored once.
class LaplacianSystem {
 public:
  /// row_weights: #patch, D's diagonal; none where all rows count alike. Throws DeformError if the
  /// factorization fails.
  LaplacianSystem(const Patch& patch, System system, const Eigen::VectorXd& row_weights = {});

  /// What the step from p to p′ of F is solved from, free x 3. rows: r − L p, rows x 3, the fixed vertices
  /// already where they go; it is scratch afterwards.
  void reduce(const CellTables& cells, Positions& rows, Positions& reduced) const;

  /// Puts the steps in the place of what they are solved from, all in one pass over the factor.
  void solve_in_place(std::span<Positions> reduced, Factor::Workspace& workspace) const;

 private:
  System system_;
  Eigen::VectorXd row_weights_;  // rows, D's diagonal; empty: D = 1
  Factor factor_;                // of N = L_fᵀ D L_f, or of L_ff
};

}  // namespace flexkey
