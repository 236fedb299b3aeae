#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <span>
#include <vector>

#include "flexkey/deform/ordering.h"
#include "flexkey/mesh/types.h"

namespace flexkey {

/// The Cholesky factor of a sparse symmetric positive definite matrix, made once and used every frame.
/// Any number of threads gives the same bytes.
class Factor {
 public:
  /// matrix: n x n, both triangles. Throws DeformError where it is singular to working precision.
  explicit Factor(const Eigen::SparseMatrix<double>& matrix);

  /// order: where each row goes, as of fill_reducing_order.
  Factor(const Eigen::SparseMatrix<double>& matrix, const Permutation& order);
  ~Factor();
  Factor(Factor&&) noexcept;
  Factor& operator=(Factor&&) noexcept;

  /// What solving takes beside the factor. It grows at its first use, and again for a larger factor or batch.
  struct Workspace {
    struct alignas(64) Line {
      double numbers[8];
    };
    std::vector<Line> lines;
  };

  /// The solution of matrix * x = b, n x 3.
  Positions solve(const Positions& b) const;

  /// The same for any number of columns.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;

  /// Puts the solution in the place of each b. Up to five are solved in one pass over the factor, which costs
  /// little more than one. Threads may share the factor, each with a workspace of its own.
  void solve_in_place(std::span<Positions> b, Workspace& workspace) const;

  /// Of memory held.
  std::size_t bytes() const;

 private:
  struct Backend;
  std::unique_ptr<Backend> backend_;
};

}  // namespace flexkey
