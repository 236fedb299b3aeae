#include "flexkey/deform/local_step.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "flexkey/deform/cell_lanes.h"
#include "flexkey/deform/dispatch.h"
#include "flexkey/deform/rotation.h"

namespace flexkey {
namespace {

using lanes::width;

constexpr int grain = 64 * width;  // cells a task

/// What local_step() was called with, as plain arrays.
struct Arrays {
  const CellTables& cells;
  const DeformOptions& options;
  const double* p;
  double* R;
  double* S;

  double* rotation(int i) const { return R + 9 * static_cast<std::ptrdiff_t>(i); }
};

/// A_i = Σ ω e′ eᵀ of a cell's edges, as Σ_j (p′_i − p′_j) a_ijᵀ, into its lane.
[[gnu::always_inline]] inline void gather(const Arrays& in, int i, lanes::Mat& A, int lane) {
  using Four = double __attribute__((vector_size(4 * sizeof(double))));  // x, y, z and a spare
  const CellTables& cells = in.cells;
  const double* p_i = in.p + 3 * static_cast<std::ptrdiff_t>(i);
  const Four here{p_i[0], p_i[1], p_i[2], 0};
  Four x{}, y{}, z{};  // the columns of A_i, one for each coordinate of e
  for (int k = cells.offsets[i]; k < cells.offsets[i + 1]; ++k) {
    const double* p_j = in.p + 3 * static_cast<std::ptrdiff_t>(cells.neighbours[k]);
    const double* a = cells.edges.data() + 3 * static_cast<std::ptrdiff_t>(k);
    const Four e = here - Four{p_j[0], p_j[1], p_j[2], 0};
    x += e * a[0];
    y += e * a[1];
    z += e * a[2];
  }
  const double columns[9] = {x[0], x[1], x[2], y[0], y[1], y[2], z[0], z[1], z[2]};
  lanes::put(columns, A, lane);
}

/// R_i of a cell that lanes do not settle: collapsed, folded, reflected, flat or far from before.
void fit_alone(const Arrays& in, int i, lanes::Ascent& block, int lane) {
  Eigen::Matrix3d A;
  lanes::take(block.A, lane, A.data());
  const Eigen::Map<const Eigen::Matrix3d> previous(in.rotation(i));
  const bool has_shape = A.norm() > lanes::collapsed * in.cells.moments.size[i];
  const Eigen::Matrix3d R = has_shape ? best_rotation(A, previous) : previous;
  lanes::put(R.data(), block.R, lane);
}

[[gnu::always_inline]] inline void ascend(lanes::Ascent& block) {
  constexpr int most_steps = 8;
  for (int k = 0; k < most_steps && !block.is_done(); ++k) block.step();
}

FLEXKEY_CLONES void fit_cells(const Arrays& in, int begin, int end) {
  lanes::Ascent block{};
  for (int first = begin; first < end; first += width) {
    const int count = std::min(width, end - first);
    for (int lane = 0; lane < count; ++lane) {
      gather(in, first + lane, block.A, lane);
      lanes::put(in.rotation(first + lane), block.R, lane);
    }
    block.begin(count, in.cells.moments.size.data() + first);
    ascend(block);
    for (int lane = 0; lane < count; ++lane) {
      if (block.doubtful[lane] || block.moving[lane]) fit_alone(in, first + lane, block, lane);
    }
    const lanes::Vec S = lanes::best_scales(block.A, block.R, in.cells.moments, first, in.options);
    for (int lane = 0; lane < count; ++lane) {
      lanes::take(block.R, lane, in.rotation(first + lane));
      lanes::take(S, lane, in.S + 3 * static_cast<std::ptrdiff_t>(first + lane));
    }
  }
}

}  // namespace

void local_step(const CellTables& cells, const DeformOptions& options, const Positions& positions,
                Transforms& transforms) {
  if (cells.fitted == 0) return;
  const Arrays arrays{cells, options, positions.data(), transforms.rotations.data()->data(),
                      transforms.scales.data()};
  const int count = cells.fitted;
  tbb::parallel_for(0, (count + grain - 1) / grain,
                    [&](int task) { fit_cells(arrays, task * grain, std::min(count, (task + 1) * grain)); });
}

}  // namespace flexkey
