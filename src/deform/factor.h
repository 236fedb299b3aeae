#pragma once

#include <Eigen/SparseCore>
#include <memory>

#include "flexkey/mesh/types.h"

namespace flexkey {

/// The Cholesky factor of a sparse symmetric positive definite matrix, made once and used every frame.
class Factor {
 public:
  /// matrix: n x n, both triangles. Throws DeformError where it is singular to working precision.
  explicit Factor(const Eigen::SparseMatrix<double>& matrix);
  ~Factor();
  Factor(Factor&&) noexcept;
  Factor& operator=(Factor&&) noexcept;

  /// The solution of matrix * x = b, n x 3.
  Positions solve(const Positions& b) const;

 private:
  struct Backend;
  std::unique_ptr<Backend> backend_;
};

}  // namespace flexkey
