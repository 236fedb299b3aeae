#pragma once

#include <Eigen/Core>
#include <vector>

#include "flexkey/mesh/types.h"

namespace flexkey {

/// The last iterates x of a fixed-point iteration with f = G(x) − x, and the products of their differences:
/// Δf_a, Δx_a and ΔG_a lead from an iterate to the next, a = 0 to the newest. Memory is taken on the first
/// call and then reused; the sums do not depend on the number of threads.
class History {
 public:
  /// window: how many differences are kept.
  explicit History(int window);

  /// The next iterate, n x 3, with its f. n never changes.
  void add(const Positions& x, const Positions& f);
  /// Drops all differences.
  void forget() { differences_ = 0; }

  int differences() const { return differences_; }
  double product(int a, int b) const { return products_(slots_[a], slots_[b]); }  // Δf_a · Δf_b
  double along(int a) const { return along_(a); }                                 // Δf_a · f of the newest
  double way(int a) const { return way_(slots_[a]); }                             // ‖Δx_a‖
  double residual() const { return residual_; }                                   // ‖f‖ of the newest

  /// G(x) of the newest less Σ γ_a ΔG_a, n x 3, valid until the next call. gamma: a number a difference.
  const Positions& mix(const Eigen::VectorXd& gamma);

 private:
  void sum_up();

  std::vector<int> slots_;    // the column of each iterate, the newest first
  int differences_ = -1;      // -1: there is no iterate yet
  Eigen::MatrixXd f_, g_;     // f and G(x) of the iterates, 3 n and zeros to whole chunks
  Eigen::MatrixXd shares_;    // a column a chunk: its share of each sum
  Eigen::MatrixXd products_;  // of the differences, by the column that each leads to
  Eigen::VectorXd along_;     // of the differences by age
  Eigen::VectorXd way_;       // by column, as the products
  double residual_ = 0;
  Positions mixed_;
};

}  // namespace flexkey
