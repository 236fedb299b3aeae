#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "flexkey/deform/deformer.h"

namespace flexkey {

/// A soft handle: vertices of F that are drawn towards their targets.
struct SoftHandle {
  int handle = 0;             // its number among all handles
  double strength = 0;        // s in (0, 1), about the share of the way that it goes
  std::vector<int> vertices;  // of F
  std::vector<int> targets;   // of each, its row among the frame's targets
};

/// What draws them: w‖p′ − c‖² is added to the energy of the global step for each vertex.
struct Springs {
  std::vector<int> vertices;  // of F
  std::vector<int> targets;   // of each, its row among the frame's targets
  Eigen::VectorXd stiffness;  // w of each
};

/// How strongly each handle holds, from Constraints::strengths; 1 where nothing is said.
double strength_of(const Constraints& constraints, int handle);

/// The handle that leads handle vertex k.
int owner_of(const Constraints& constraints, std::size_t k);

/// places: of each handle vertex in the patch, or -1. free: the size of F.
std::vector<SoftHandle> soft_handles(const Constraints& constraints, const std::vector<int>& places,
                                     int free);

/// w = (E/m)·s/(1 − s) of each soft handle, m its vertices. E is the least xᵀ N x in which they move by one
/// unit together while every other handle, hard or soft, stays: were the surface linear, the handle would go
/// the share s of its way. Where nothing but the handle holds the surface any w takes it all the way, and E
/// is the sum of the handle's N_ii. N: free x free, symmetric; one factorization serves all handles.
Eigen::VectorXd soft_stiffness(const Eigen::SparseMatrix<double>& N, const std::vector<SoftHandle>& handles);

Springs make_springs(const Eigen::SparseMatrix<double>& N, const std::vector<SoftHandle>& handles);

/// N + w on the diagonal of each spring's vertex.
Eigen::SparseMatrix<double> with_springs(Eigen::SparseMatrix<double> N, const Springs& springs);

/// Adds w (c − p) to the force on each spring's vertex. lacking: #springs x 3, c − p. force: free x 3.
void pull(const Springs& springs, const Positions& lacking, Positions& force);

}  // namespace flexkey
