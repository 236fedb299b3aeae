#pragma once

#include "flexkey/deform/history.h"
#include "flexkey/mesh/types.h"

namespace flexkey {

/// Anderson acceleration of x -> G(x): the next x is the mixture of the last few G(x) whose residuals
/// f = G(x) - x cancel best (Walker and Ni, "Anderson acceleration for fixed-point iterations", 2011).
class Anderson {
 public:
  /// window: how many differences of iterates are kept.
  Anderson() : Anderson(8) {}
  explicit Anderson(int window) : history_(window) {}

  /// From x and its residual f, both n x 3, the next x, which is valid until the next call. With an empty
  /// window it is the plain step x + f. Where a residual grew past what a mixture may cost, the window is
  /// dropped and the plain step taken.
  const Mixture& next(const Positions& x, const Positions& f);

  /// Another map comes, near the last, such as the next frame's: its slow directions are nearly the same, so
  /// the window is kept.
  void turn_to_next_map();

  int differences() const { return history_.differences(); }
  /// Whether all that the window can hold comes from this map.
  bool is_full() const { return history_.own() == history_.window(); }

  /// How much farther the fixed point may be than the residual says: the largest ‖ΔX c‖/‖ΔF c‖ over all
  /// combinations of one map's differences, a lower bound of ‖(1 − G′)⁻¹‖, for the slowest of all maps so
  /// far. 0 while there was no difference.
  double stretch() const { return stretch_; }

  /// What the next map is turned to with, for an archive.
  template <MaybeConst<Anderson> Self>
  static auto members_of(Self& self) {
    return std::tie(self.history_, self.stretch_);
  }
  /// Whether a loaded one is sound and of iterates with so many rows.
  bool fits(Eigen::Index rows) const { return stretch_ >= 0 && history_.fits(rows); }

 private:
  History history_;
  double stretch_ = 0;
  double before_ = 0;  // ‖f‖ at the last call for this map; 0: there was none
};

}  // namespace flexkey
