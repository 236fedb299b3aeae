#include "flexkey/deform/cholesky.h"

namespace flexkey {

std::optional<Cholesky> cholesky(const Eigen::SparseMatrix<double>& matrix, const Permutation& order) {
  return simplicial_cholesky(matrix, order);
}

}  // namespace flexkey
