#pragma once

#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "flexkey/deform/factor.h"
#include "flexkey/deform/rigid.h"

namespace flexkey {

/// The least ½ xᵀ N x − fᵀ x over all that the vertices of F can do, regions moving as one body each.
///
/// The step is x = C u + Σ A_k M_kᵀ: u moves the vertices outside the regions and the regions as a whole, A_k
/// has the arms of region k as rows, and M_k is the change of its Q_k. For given M the best u is
/// u = (CᵀNC)⁻¹ Cᵀf − Y Mᵀ with Y = (CᵀNC)⁻¹ CᵀNA, whose matrix is constant. With it the energy is
/// ½ tr(M G Mᵀ) − tr(F Mᵀ), G = AᵀNA − AᵀNC Y, F = fᵀA − fᵀC Y; and since tr(Q G Qᵀ) is the same for every
/// rotation, the best Q of a region is the Procrustes fit of Q G + F. So its forces balance, and their
/// moments.
class RigidSystem {
 public:
  /// N: free x free, positive definite. Without regions it is factored as it is. places: of each vertex of F
  /// in an order of elimination; empty: one is found. Throws DeformError.
  RigidSystem(const Eigen::SparseMatrix<double>& N, std::vector<RigidRegion> regions,
              const std::vector<int>& places = {});

  /// The step of the vertices of F, free x 3, for the force f on them, free x 3. transforms: whose Q_k the
  /// regions are placed by.
  Positions step(const Positions& force, const Transforms& transforms) const;

  /// Puts the steps in the place of the forces, each with its transforms; without regions in one pass.
  void solve_in_place(std::span<Positions> forces, std::span<const Transforms* const> transforms,
                      Factor::Workspace& workspace) const;

  /// The factor of N; none with regions.
  const Factor* plain_factor() const { return regions_.empty() ? &factor_ : nullptr; }

  /// Of memory held.
  std::size_t bytes() const;

 private:
  using Matrix = Eigen::SparseMatrix<double>;
  Eigen::MatrixXd best_turns(const Eigen::MatrixXd& F, const Transforms& transforms) const;

  std::vector<RigidRegion> regions_;
  Matrix C_;                   // free x #unknowns; empty without regions, as what follows but the factor
  Matrix A_;                   // free x 3 #regions
  Factor factor_;              // of CᵀNC
  Eigen::MatrixXd response_;   // Y, #unknowns x 3 #regions
  Eigen::MatrixXd stiffness_;  // G, 3 #regions x 3 #regions
};

}  // namespace flexkey
