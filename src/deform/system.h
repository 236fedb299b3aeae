#pragma once

#include <Eigen/SparseCore>
#include <span>

#include "flexkey/deform/cell_tables.h"
#include "flexkey/deform/options.h"
#include "flexkey/deform/patch.h"
#include "flexkey/deform/rigid_system.h"
#include "flexkey/deform/ties.h"

namespace flexkey {

/// The global step: the p′ that meets the fixed vertices exactly and solves the rest of eq 7 (least squares
/// over all rows, each scaled by the root of its weight) or of eq 5 (`direct`: the rows of F,
/// L_ff p′_f = r_f − L_fc c), with w‖p′ − c‖² for each vertex of a soft handle, and over what rigid regions
/// can do. Factored once.
class LaplacianSystem {
 public:
  /// row_weights: #patch, D's diagonal; none where all rows count alike. Throws DeformError if the
  /// factorization fails.
  LaplacianSystem(const Patch& patch, System system, const Ties& ties = {},
                  const Eigen::VectorXd& row_weights = {});

  /// The factor of N, or none where springs or rigid regions are in it.
  const Factor* plain_factor() const;

  const Springs& springs() const { return springs_; }

  /// The force on the vertices of F that a step comes from, free x 3, without that of the springs. rows:
  /// r − L p, rows x 3, the fixed vertices already where they go; it is scratch afterwards.
  void reduce(const CellTables& cells, Positions& rows, Positions& force) const;

  /// Puts the steps in the place of the forces, in one pass over the factor where there are no rigid regions.
  /// transforms: of each, which the regions are placed by.
  void solve_in_place(std::span<Positions> forces, std::span<const Transforms* const> transforms,
                      Factor::Workspace& workspace) const;

  /// Of memory held.
  std::size_t bytes() const { return tied_.bytes(); }

 private:
  using Matrix = Eigen::SparseMatrix<double>;
  LaplacianSystem(System system, const Matrix& N, const Ties& ties);

  System system_;
  Eigen::VectorXd row_weights_;  // rows, D's diagonal; empty: D = 1
  Springs springs_;
  RigidSystem tied_;  // N = L_fᵀ D L_f, or L_ff, with the springs
};

}  // namespace flexkey
