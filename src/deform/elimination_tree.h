#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "flexkey/deform/ordering.h"

namespace flexkey {

/// The elimination tree of P A P^-1: the parent of each column, or -1 (J. W. H. Liu, "The role of elimination
/// trees in sparse factorization", 1990).
std::vector<int> elimination_tree(const Eigen::SparseMatrix<double>& symmetric, const Permutation& order);

/// The place of each node in a postorder of the forest: children before parents, subtrees together.
std::vector<int> postorder(const std::vector<int>& parents);

}  // namespace flexkey
