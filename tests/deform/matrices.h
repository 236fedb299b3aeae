#pragma once

#include <Eigen/SparseCore>
#include <cmath>
#include <vector>

namespace flexkey {

/// The Laplacian of a grid of rows x columns places, all held by a spring of this strength.
inline Eigen::SparseMatrix<double> grid(int rows, int columns, double spring = 0.1) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto join = [&](int i, int j) {
    const double weight = 1 + 0.5 * std::sin(i + 3.0 * j);  // no two alike
    entries.emplace_back(i, i, weight);
    entries.emplace_back(j, j, weight);
    entries.emplace_back(i, j, -weight);
    entries.emplace_back(j, i, -weight);
  };
  for (int i = 0; i < rows * columns; ++i) {
    entries.emplace_back(i, i, spring);
    if ((i + 1) % columns != 0) join(i, i + 1);
    if (i + columns < rows * columns) join(i, i + columns);
  }
  Eigen::SparseMatrix<double> matrix(rows * columns, rows * columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Blocks of several sizes that do not touch, some of one row.
inline Eigen::SparseMatrix<double> islands() {
  std::vector<Eigen::Triplet<double>> entries;
  int first = 0;
  for (const int side : {1, 6, 1, 1, 3, 8, 1}) {
    const Eigen::SparseMatrix<double> island = grid(side, side);
    for (int k = 0; k < island.outerSize(); ++k) {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(island, k); entry; ++entry) {
        entries.emplace_back(first + static_cast<int>(entry.row()), first + k, entry.value());
      }
    }
    first += side * side;
  }
  Eigen::SparseMatrix<double> matrix(first, first);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

inline Eigen::SparseMatrix<double> squared(const Eigen::SparseMatrix<double>& matrix) {
  return matrix.transpose() * matrix;
}

}  // namespace flexkey
