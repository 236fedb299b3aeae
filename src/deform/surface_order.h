#pragma once

#include <vector>

#include "flexkey/deform/factor.h"
#include "flexkey/deform/options.h"
#include "flexkey/deform/ordering.h"
#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// An order of elimination of a whole surface: the place of each vertex, #V. What is held drops out of it,
/// and what remains is in an order with little fill, so that it serves every set of constraints.
std::vector<int> surface_order(const Mesh& rest, const DeformOptions& options);

/// The order of some vertices among themselves, from the place of each; equal places keep their order.
Permutation order_of(const std::vector<int>& places);

/// Factors a matrix in the order of these places of its rows; without any, one is found.
Factor factor_in_order(const Eigen::SparseMatrix<double>& matrix, const std::vector<int>& places);

}  // namespace flexkey
