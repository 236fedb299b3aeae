#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace flexkey {

/// What a float accessor holds: #rows x 1 (SCALAR), 2 (VEC2), 3 (VEC3) or 4 (VEC4), rows side by side in
/// memory.
using FloatRows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Rows of integers, side by side in memory.
using ShortRows = Eigen::Matrix<std::int16_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Rows of which most may be zero: only those that `indices` names are kept.
struct SparseRows {
  std::int64_t count = 0;              // rows in all
  std::vector<std::uint32_t> indices;  // of the rows kept, strictly increasing, at least one
  FloatRows values;                    // #indices x columns
};

/// The rows that are not all zero; row 0 where all are, because glTF wants at least one.
SparseRows nonzero_rows(const FloatRows& rows);

/// All rows written out, count x columns.
FloatRows dense_rows(const SparseRows& rows);

/// Bytes of the smallest unsigned integer that holds `largest`: 1, 2 or 4.
int index_bytes(std::int64_t largest);

/// Bytes rounded up to glTF's alignment of 4.
std::int64_t aligned(std::int64_t bytes);

/// Bytes in the buffer of `rows` rows of `columns` floats.
std::int64_t dense_bytes(std::int64_t rows, int columns);

/// Bytes in the buffer of `kept` rows of `columns` floats and their indices, the last of which is `largest`.
std::int64_t sparse_bytes(std::int64_t kept, std::int64_t largest, int columns);

}  // namespace flexkey
