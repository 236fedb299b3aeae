#include <iostream>  // Eigen/MetisSupport names std::cerr and includes nothing

#include <Eigen/MetisSupport>

#include "flexkey/deform/ordering.h"

namespace flexkey {

Permutation fill_reducing_order(const Eigen::SparseMatrix<double>& symmetric) {
  Permutation inverse;
  Eigen::MetisOrdering<int>()(symmetric, inverse);
  return inverse.inverse();
}

}  // namespace flexkey
