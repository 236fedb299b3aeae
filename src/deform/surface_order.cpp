#include "flexkey/deform/surface_order.h"

#include <algorithm>
#include <numeric>

#include "flexkey/deform/weights.h"

namespace flexkey {

std::vector<int> surface_order(const Mesh& rest, const DeformOptions& options) {
  const Cells cells = build_cells(rest, options.weights);
  std::vector<Eigen::Triplet<double>> entries;
  for (int v = 0; v < cells.count(); ++v) {
    entries.emplace_back(v, v, 1.0);
    for (const auto [j, weight] : cells.of(v)) entries.emplace_back(v, j, 1.0);
  }
  Eigen::SparseMatrix<double> pattern(cells.count(), cells.count());
  pattern.setFromTriplets(entries.begin(), entries.end());
  // Lᵀ L joins the neighbours of neighbours too.
  if (options.system == System::least_squares) pattern = Eigen::SparseMatrix<double>(pattern * pattern);
  const Permutation order = fill_reducing_order(pattern);
  return {order.indices().begin(), order.indices().end()};
}

Permutation order_of(const std::vector<int>& places) {
  std::vector<int> sorted(places.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  std::stable_sort(sorted.begin(), sorted.end(), [&](int a, int b) { return places[a] < places[b]; });
  Permutation order(static_cast<Eigen::Index>(places.size()));
  for (std::size_t k = 0; k < sorted.size(); ++k) order.indices()(sorted[k]) = static_cast<int>(k);
  return order;
}

Factor factor_in_order(const Eigen::SparseMatrix<double>& matrix, const std::vector<int>& places) {
  return places.empty() ? Factor(matrix) : Factor(matrix, order_of(places));
}

}  // namespace flexkey
