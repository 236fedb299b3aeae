#include "flexkey/deform/cell_tables.h"

#include <cmath>

namespace flexkey {
namespace {

void add(const Vec3& e, double weight, RestMoments& sums) {
  const Vec3 we = weight * e;
  sums.xx += we.x() * e.x();
  sums.yy += we.y() * e.y();
  sums.zz += we.z() * e.z();
  sums.xy += we.x() * e.y();
  sums.yz += we.y() * e.z();
  sums.zx += we.z() * e.x();
  sums.size += std::abs(weight) * e.squaredNorm();
}

}  // namespace

CellTables tabulate(const Patch& patch) {
  const auto edge_count = static_cast<Eigen::Index>(patch.cells.edges.size());
  CellTables tables;
  tables.free = patch.free;
  tables.rows = patch.rows;
  tables.offsets = patch.cells.offsets;
  tables.edges.resize(edge_count, 3);
  tables.moments.resize(patch.fitted);
  for (int i = 0; i < patch.fitted; ++i) {
    for (const auto [j, weight] : patch.cells.of(i)) {
      const Vec3 e = patch.rest.row(i) - patch.rest.row(j);
      tables.edges.row(static_cast<Eigen::Index>(tables.weights.size())) = weight * e;
      tables.neighbours.push_back(j);
      tables.weights.push_back(weight);
      add(e, weight, tables.moments[i]);
    }
  }
  return tables;
}

}  // namespace flexkey
