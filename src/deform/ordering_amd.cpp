#include <Eigen/OrderingMethods>

#include "flexkey/deform/ordering.h"

namespace flexkey {

Permutation fill_reducing_order(const Eigen::SparseMatrix<double>& symmetric) {
  Permutation inverse;
  Eigen::AMDOrdering<int>()(symmetric, inverse);
  return inverse.inverse();
}

}  // namespace flexkey
