#pragma once

#include <deque>

#include "flexkey/mesh/types.h"

namespace flexkey {

/// Anderson acceleration of x -> G(x): the next x is the mixture of the last few G(x) whose residuals
/// f = G(x) - x cancel best (Walker and Ni, "Anderson acceleration for fixed-point iterations", 2011).
class Anderson {
 public:
  /// window: how many differences of iterates are kept.
  explicit Anderson(int window) : window_(window) {}

  /// From x and its residual f, both n x 3, the next x. The first call gives the plain step x + f. Where a
  /// residual grew past what a mixture may cost, the window is dropped and the plain step taken.
  Positions next(const Positions& x, const Positions& f);

  /// Largest ‖Δx‖/‖Δf‖ of the window: how much farther the fixed point may be than the residual says.
  /// 0 before the second call.
  double stretch() const { return stretch_; }

 private:
  void remember(const Positions& x, const Positions& f);
  Positions mixture(const Positions& x, const Positions& f) const;

  int window_;
  Positions x_, f_;                // of the last call; empty before the first
  std::deque<Positions> dx_, df_;  // differences, the oldest first
  double stretch_ = 0;
};

}  // namespace flexkey
