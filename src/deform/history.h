#pragma once

#include <Eigen/Core>
#include <tuple>
#include <vector>

#include "flexkey/mesh/members.h"
#include "flexkey/mesh/types.h"

namespace flexkey {

/// What the window makes of the newest iterate x.
struct Mixture {
  Positions positions;  // n x 3, G(x) − Σ γ_a ΔG_a
  double jump = 0;      // the longest row of positions − x
  double left = 0;      // the longest row of f − Σ γ_a Δf_a: what the window cannot cancel
};

/// The last differences between iterates x of a fixed-point iteration with f = G(x) − x, and their products:
/// Δf_a, Δx_a and ΔG_a lead from an iterate to the next, a = 0 to the newest. Memory is taken while the
/// window fills and then reused; the sums do not depend on the number of threads.
class History {
 public:
  /// window: how many differences are kept.
  explicit History(int window);

  /// The next iterate, n x 3, with its f. n never changes.
  void add(const Positions& x, const Positions& f);
  /// The next iterate will make no difference with the last: it answers to other targets.
  void part() {
    follows_ = false;
    own_ = 0;
  }
  /// Drops all differences.
  void forget() { differences_ = own_ = 0; }

  int window() const { return static_cast<int>(slots_.size()); }
  int differences() const { return differences_; }
  int own() const { return own_; }  // how many of the newest came since the last part()
  double product(int a, int b) const { return products_(slots_[a], slots_[b]); }  // Δf_a · Δf_b
  double along(int a) const { return along_(a); }                                 // Δf_a · f of the newest
  double way_product(int a, int b) const { return ways_(slots_[a], slots_[b]); }  // Δx_a · Δx_b of own ones
  double residual() const { return residual_; }                                   // ‖f‖ of the newest

  /// gamma: a number a difference; valid until the next call.
  const Mixture& mix(const Eigen::VectorXd& gamma);

  /// What outlives a sequence (see `part`), for an archive.
  template <MaybeConst<History> Self>
  static auto members_of(Self& self) {
    return std::tie(self.slots_, self.differences_, self.f_change_, self.g_change_, self.products_);
  }
  /// Whether a loaded one is sound and of iterates with so many rows.
  bool fits(Eigen::Index rows) const;

 private:
  void sum_up(bool grew);

  std::vector<int> slots_;  // the place of each difference, the newest first
  int differences_ = 0;
  int own_ = 0;
  bool follows_ = false;                              // whether the last iterate is of the same sequence
  Eigen::VectorXd f_, g_;                             // of the last iterate: 3 n and zeros to whole chunks
  std::vector<Eigen::VectorXd> f_change_, g_change_;  // by place: Δf and ΔG, likewise
  Eigen::MatrixXd shares_;                            // a column a chunk: its share of each sum
  Eigen::MatrixXd products_;                          // of the differences, by place
  Eigen::VectorXd along_;                             // by age
  Eigen::MatrixXd ways_;                              // of the own differences, by place
  double residual_ = 0;
  Mixture mixture_;
};

}  // namespace flexkey
