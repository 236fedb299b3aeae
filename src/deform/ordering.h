#pragma once

#include <Eigen/SparseCore>

namespace flexkey {

using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

/// An order of elimination with little fill: factor P A P^-1 in the place of A. One of cholmod.cpp and
/// ordering_*.cpp is built: nested dissection by METIS where it is installed, minimum degree otherwise; with
/// CHOLMOD minimum degree within the parts of a dissection.
Permutation fill_reducing_order(const Eigen::SparseMatrix<double>& symmetric);

}  // namespace flexkey
