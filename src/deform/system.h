#pragma once

#include <Eigen/SparseCore>

#include "flexkey/deform/factor.h"
#include "flexkey/deform/options.h"
#include "flexkey/deform/patch.h"

namespace flexkey {

/// L x on the first `rows` vertices, rows x 3: (L x)_i = Σ_j ω_ij (x_i − x_j).
Positions laplacian(const Cells& cells, int rows, const Positions& x);

/// The global step: the p′ that meets the fixed vertices exactly and solves the rest of eq 7 (least squares
/// over all rows) or of eq 5 (`direct`: the rows of F, L_ff p′_f = r_f − L_fc c). Factored once.
class LaplacianSystem {
 public:
  /// Throws DeformError if the factorization fails.
  LaplacianSystem(const Patch& patch, System system);

  /// The step from p to p′ of the vertices of F, free x 3.
  /// r: rows x 3, the right-hand side of eq 4. p: #patch x 3, the fixed vertices already where they go.
  Positions step(const Patch& patch, const Positions& r, const Positions& p) const;

 private:
  System system_;
  Factor factor_;  // of N = L_fᵀ L_f, or of L_ff
};

}  // namespace flexkey
