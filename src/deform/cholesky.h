#pragma once

#include <Eigen/SparseCore>
#include <optional>
#include <string>

#include "flexkey/deform/ordering.h"
#include "flexkey/deform/supernodes.h"

namespace flexkey {

/// P A P^-1 = L Lᵀ.
struct Cholesky {
  Permutation order;  // P
  Supernodes L;
};

/// Factors a symmetric matrix, both triangles given, in this order of elimination but for a postorder of the
/// elimination tree, which changes no fill and brings the columns of a subtree together. Nothing where a
/// pivot is not positive. By CHOLMOD (cholmod.cpp) where it is installed, by Eigen
/// (cholesky_simplicial.cpp) otherwise.
std::optional<Cholesky> cholesky(const Eigen::SparseMatrix<double>& matrix, const Permutation& order);

/// The same by Eigen's simplicial LLᵀ, which is always there.
std::optional<Cholesky> simplicial_cholesky(const Eigen::SparseMatrix<double>& matrix,
                                            const Permutation& order);

/// What cholesky() factors with: "CHOLMOD 3.0.14".
std::string factoring_library();

}  // namespace flexkey
