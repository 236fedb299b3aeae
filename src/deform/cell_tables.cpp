#include "flexkey/deform/cell_tables.h"

#include <cmath>

namespace flexkey {

RestMoments no_moments(int fitted) {
  const std::vector<double> zero((static_cast<std::size_t>(fitted) + 7) / 8 * 8);
  return {zero, zero, zero, zero, zero, zero, zero, zero};
}

void add_moments(const Vec3& e, double weight, RestMoments& sums, int i) {
  const Vec3 we = weight * e;
  sums.trace[i] += we.dot(e);
  sums.size[i] += std::abs(weight) * e.squaredNorm();
  sums.xx[i] += we.x() * e.x();
  sums.yy[i] += we.y() * e.y();
  sums.zz[i] += we.z() * e.z();
  sums.xy[i] += we.x() * e.y();
  sums.yz[i] += we.y() * e.z();
  sums.zx[i] += we.z() * e.x();
}

CellTables tabulate(const Patch& patch) {
  const auto edge_count = static_cast<Eigen::Index>(patch.cells.edges.size());
  CellTables tables;
  tables.free = patch.free;
  tables.rows = patch.rows;
  tables.fitted = patch.fitted;
  tables.offsets = patch.cells.offsets;
  tables.edges.resize(edge_count, 3);
  tables.neighbours.reserve(patch.cells.edges.size());
  tables.weights.reserve(patch.cells.edges.size());
  tables.moments = no_moments(patch.fitted);
  for (int i = 0; i < patch.fitted; ++i) {
    for (const auto [j, weight] : patch.cells.of(i)) {
      const Vec3 e = patch.rest.row(i) - patch.rest.row(j);
      tables.edges.row(static_cast<Eigen::Index>(tables.weights.size())) = weight * e;
      tables.neighbours.push_back(j);
      tables.weights.push_back(weight);
      add_moments(e, weight, tables.moments, i);
    }
  }
  return tables;
}

}  // namespace flexkey
