#include <mutex>

#include "flexkey/deform/dissection.h"

namespace flexkey {

Permutation fill_reducing_order(const Eigen::SparseMatrix<double>& symmetric) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  return dissection_order(symmetric);
}

}  // namespace flexkey
