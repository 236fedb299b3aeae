#pragma once

#include "flexkey/deform/ordering.h"

namespace flexkey {

/// The order of METIS's multilevel nested dissection for a symmetric matrix. Not to be called by two threads
/// at once: METIS draws from libc's one sequence of random numbers. Throws std::bad_alloc.
Permutation dissection_order(const Eigen::SparseMatrix<double>& symmetric);

}  // namespace flexkey
