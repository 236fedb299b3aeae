#pragma once

#include <Eigen/SparseCore>

#include "flexkey/deform/cell_tables.h"
#include "flexkey/deform/factor.h"
#include "flexkey/deform/options.h"
#include "flexkey/deform/patch.h"

namespace flexkey {

/// What a global step starts from. The caller keeps it, so that steps need not allocate.
struct Residuals {
  Positions rows;    // rows x 3, r − L p
  Positions normal;  // free x 3, L_fᵀ (r − L p); scratch of `least-squares`
};

/// The global step: the p′ that meets the fixed vertices exactly and solves the rest of eq 7 (least squares
/// over all rows) or of eq 5 (`direct`: the rows of F, L_ff p′_f = r_f − L_fc c). Factored once.
class LaplacianSystem {
 public:
  /// Throws DeformError if the factorization fails.
  LaplacianSystem(const Patch& patch, System system);

  /// The step from p to p′ of the vertices of F, free x 3, where residuals.rows is r − L p with the fixed
  /// vertices already where they go.
  Positions step(const CellTables& cells, Residuals& residuals) const;

 private:
  System system_;
  Factor factor_;  // of N = L_fᵀ L_f, or of L_ff
};

}  // namespace flexkey
