#pragma once

#include "flexkey/deform/history.h"
#include "flexkey/mesh/types.h"

namespace flexkey {

/// Anderson acceleration of x -> G(x): the next x is the mixture of the last few G(x) whose residuals
/// f = G(x) - x cancel best (Walker and Ni, "Anderson acceleration for fixed-point iterations", 2011).
class Anderson {
 public:
  /// window: how many differences of iterates are kept.
  explicit Anderson(int window) : history_(window) {}

  /// From x and its residual f, both n x 3, the next x, which is valid until the next call. The first call
  /// gives the plain step x + f. Where a residual grew past what a mixture may cost, the window is dropped
  /// and the plain step taken.
  const Positions& next(const Positions& x, const Positions& f);

  /// Largest ‖Δx‖/‖Δf‖ of the window: how much farther the fixed point may be than the residual says.
  /// 0 before the second call.
  double stretch() const { return stretch_; }

 private:
  History history_;
  double stretch_ = 0;
};

}  // namespace flexkey
