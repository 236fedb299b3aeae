#include "flexkey/gltf/float_rows.h"

namespace flexkey {

SparseRows nonzero_rows(const FloatRows& rows) {
  SparseRows sparse{rows.rows(), {}, {}};
  for (Eigen::Index row = 0; row < rows.rows(); ++row) {
    if ((rows.row(row).array() != 0.0F).any()) sparse.indices.push_back(static_cast<std::uint32_t>(row));
  }
  if (sparse.indices.empty()) sparse.indices.push_back(0);
  sparse.values = rows(sparse.indices, Eigen::all);
  return sparse;
}

FloatRows dense_rows(const SparseRows& rows) {
  FloatRows dense = FloatRows::Zero(rows.count, rows.values.cols());
  dense(rows.indices, Eigen::all) = rows.values;
  return dense;
}

int index_bytes(std::int64_t largest) {
  if (largest <= UINT8_MAX) return 1;
  return largest <= UINT16_MAX ? 2 : 4;
}

std::int64_t aligned(std::int64_t bytes) {
  return (bytes + 3) / 4 * 4;
}

std::int64_t dense_bytes(std::int64_t rows, int columns) {
  return rows * columns * static_cast<std::int64_t>(sizeof(float));
}

std::int64_t sparse_bytes(std::int64_t kept, std::int64_t largest, int columns) {
  return aligned(kept * index_bytes(largest)) + dense_bytes(kept, columns);
}

}  // namespace flexkey
