#pragma once

#include <array>
#include <vector>

#include "flexkey/deform/partition.h"
#include "flexkey/deform/supernodes.h"
#include "flexkey/deform/sweep.h"

namespace flexkey {

/// Up to 16 right-hand sides, each in place: number i of column c lies at columns[c][i * stride].
struct RightHandSides {
  static constexpr int most = 16;
  std::array<double*, most> columns{};
  int count = 0;
  int stride = 1;

  /// In one row of x: 4, 8 or 16.
  int width() const { return count <= 4 ? 4 : count <= 8 ? 8 : 16; }
};

/// P A P^-1 = L Lᵀ, ready to solve.
struct Substitution {
  std::vector<int> rows;  // the row of A that each row of L is
  Supernodes L;
  Partition partition;
  const Sweeps* sweeps = nullptr;
};

/// A x = b for each b, in its place. x: partition.rows rows of width() numbers, on a boundary of 64 bytes.
void substitute(const Substitution& factor, const RightHandSides& b, double* x);

}  // namespace flexkey
