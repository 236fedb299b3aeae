#include <fmt/format.h>

#include "flexkey/deform/cholesky.h"

namespace flexkey {

std::optional<Cholesky> cholesky(const Eigen::SparseMatrix<double>& matrix, const Permutation& order) {
  return simplicial_cholesky(matrix, order);
}

std::string factoring_library() {
  return fmt::format("Eigen {}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
}

}  // namespace flexkey
