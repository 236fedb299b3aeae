#pragma once

#include <Eigen/SparseCore>

namespace flexkey {

using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

/// An order of elimination with little fill: factor P A P^-1 in the place of A. One of ordering_*.cpp is
/// built: nested dissection by METIS where it is installed, minimum degree otherwise.
Permutation fill_reducing_order(const Eigen::SparseMatrix<double>& symmetric);

}  // namespace flexkey
