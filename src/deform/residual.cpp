#include "flexkey/deform/residual.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "flexkey/deform/dispatch.h"

namespace flexkey {
namespace {

constexpr int grain = 512;  // rows a task

using Four = double __attribute__((vector_size(4 * sizeof(double))));    // x, y, z and a spare
using Loose __attribute__((aligned(sizeof(double)), may_alias)) = Four;  // anywhere in memory

/// Row i of an n x 3 array, or the matrix i of an array of 3 x 3.
[[gnu::always_inline]] inline const double* row(const double* first, int i) {
  return first + 3 * static_cast<std::ptrdiff_t>(i);
}
[[gnu::always_inline]] inline const double* matrix(const double* first, int i) {
  return first + 9 * static_cast<std::ptrdiff_t>(i);
}

/// What residual() was called with, as plain arrays.
struct Arrays {
  const CellTables& cells;
  const double* pulls;  // d_ij
  const double* p;
  const double* R;
  const double* S;
  const double* lambda;
  double* result;
};

FLEXKEY_CLONES void residual_rows(const Arrays& in, int begin, int end) {
  const CellTables& cells = in.cells;
  for (int i = begin; i < end; ++i) {
    const double* p_i = row(in.p, i);
    const Four here{p_i[0], p_i[1], p_i[2], 0};
    Four Lp{}, delta{};
    // Σ_j R_j d_ij: each column of R_j by one coordinate. The third is read from one entry before its start,
    // so as not to reach past the last matrix.
    Four first{}, second{}, third{};
    for (int k = cells.offsets[i]; k < cells.offsets[i + 1]; ++k) {
      const int j = cells.neighbours[k];
      const double *p_j = row(in.p, j), *d = row(in.pulls, k), *R_j = matrix(in.R, j);
      Lp += (here - Four{p_j[0], p_j[1], p_j[2], 0}) * cells.weights[k];
      delta += Four{d[0], d[1], d[2], 0};
      first += *reinterpret_cast<const Loose*>(R_j) * d[0];
      second += *reinterpret_cast<const Loose*>(R_j + 3) * d[1];
      third += *reinterpret_cast<const Loose*>(R_j + 5) * d[2];
    }
    const double *R_i = matrix(in.R, i), *S_i = row(in.S, i);
    const double lambda = in.lambda[i];
    for (int c = 0; c < 3; ++c) {
      const double turned = R_i[c] * delta[0] + R_i[3 + c] * delta[1] + R_i[6 + c] * delta[2];
      const double neighbours = first[c] + second[c] + third[c + 1];
      const double rigid = cells.own * turned + (1 - cells.own) * neighbours;
      const double r = lambda * rigid + (1 - lambda) * S_i[c] * turned;
      in.result[3 * static_cast<std::ptrdiff_t>(i) + c] = r - Lp[c];
    }
  }
}

FLEXKEY_CLONES void laplacian_rows(const CellTables& cells, const double* x, int begin, int end,
                                   double* result) {
  for (int i = begin; i < end; ++i) {
    const double* x_i = row(x, i);
    const Four here{x_i[0], x_i[1], x_i[2], 0};
    Four Lx{};
    for (int k = cells.offsets[i]; k < cells.offsets[i + 1]; ++k) {
      const double* x_j = row(x, cells.neighbours[k]);
      Lx += (here - Four{x_j[0], x_j[1], x_j[2], 0}) * cells.weights[k];
    }
    for (int c = 0; c < 3; ++c) result[3 * static_cast<std::ptrdiff_t>(i) + c] = Lx[c];
  }
}

/// Each row is worked out on its own, so that the answer does not depend on the number of threads.
template <class Rows>
void for_rows(int count, const Rows& rows) {
  tbb::parallel_for(0, (count + grain - 1) / grain,
                    [&](int task) { rows(task * grain, std::min(count, (task + 1) * grain)); });
}

}  // namespace

void residual(const CellTables& cells, const Positions& p, const Transforms& transforms,
              const Eigen::VectorXd& lambda, Positions& result) {
  result.resize(cells.rows, 3);
  if (cells.rows == 0) return;
  const Positions& pulls = cells.pulls.size() > 0 ? cells.pulls : cells.edges;
  const Arrays arrays{
      cells,         pulls.data(), p.data(), transforms.rotations.data()->data(), transforms.scales.data(),
      lambda.data(), result.data()};
  for_rows(cells.rows, [&](int begin, int end) { residual_rows(arrays, begin, end); });
}

void free_laplacian(const CellTables& cells, const Positions& x, Positions& result) {
  result.resize(cells.free, 3);
  for_rows(cells.free,
           [&](int begin, int end) { laplacian_rows(cells, x.data(), begin, end, result.data()); });
}

}  // namespace flexkey
