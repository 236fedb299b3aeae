#include "flexkey/deform/local_step.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "flexkey/deform/dispatch.h"
#include "flexkey/deform/rotation.h"
#include "flexkey/deform/rotation_lanes.h"

namespace flexkey {
namespace {

using lanes::Ascent, lanes::Vec, lanes::dot, lanes::width;
using Four = double __attribute__((vector_size(4 * sizeof(double))));  // x, y, z and a spare

constexpr int grain = 64 * width;       // cells a task
constexpr double collapsed = 1e-14;     // a cell shrunk to this share of its rest size is rounding noise
constexpr double undetermined = 1e-12;  // share of the cell's Σ ω |e|²

/// What local_step() was called with, as plain arrays.
struct Arrays {
  const CellTables& cells;
  const DeformOptions& options;
  const double* p;
  double* R;
  double* S;

  double* rotation(int i) const { return R + 9 * static_cast<std::ptrdiff_t>(i); }
};

/// A_i = Σ_j ω e′ eᵀ of a cell, a column for each coordinate of e, into its lane.
[[gnu::always_inline]] inline void gather(const Arrays& in, int i, lanes::Matrices& A, int lane) {
  const CellTables& cells = in.cells;
  const double* p_i = in.p + 3 * static_cast<std::ptrdiff_t>(i);
  const Four here{p_i[0], p_i[1], p_i[2], 0};
  Four x{}, y{}, z{};
  for (int k = cells.offsets[i]; k < cells.offsets[i + 1]; ++k) {
    const double* p_j = in.p + 3 * static_cast<std::ptrdiff_t>(cells.neighbours[k]);
    const double* we = cells.edges.data() + 3 * static_cast<std::ptrdiff_t>(k);
    const Four e = here - Four{p_j[0], p_j[1], p_j[2], 0};
    x += e * we[0];
    y += e * we[1];
    z += e * we[2];
  }
  for (int c = 0; c < 3; ++c) {
    A.entry[c][lane] = x[c];
    A.entry[3 + c][lane] = y[c];
    A.entry[6 + c][lane] = z[c];
  }
}

[[gnu::always_inline]] inline void load(const Arrays& in, int first, int count, Ascent& block) {
  for (int l = 0; l < count; ++l) {
    gather(in, first + l, block.A, l);
    const double* R = in.rotation(first + l);
    for (int k = 0; k < 9; ++k) block.R.entry[k][l] = R[k];
    block.state[l] = lanes::moving;
    // The sum of the singular values, which is compared, is at most √3 times the norm.
    block.least[l] = 2 * collapsed * in.cells.moments[first + l].size;
  }
  for (int l = count; l < width; ++l) block.state[l] = lanes::settled;
}

[[gnu::always_inline]] inline void ascend(Ascent& block) {
  constexpr int most_steps = 8;
  for (int k = 0; k < most_steps; ++k) {
    for (int l = 0; l < width; ++l) block.step(l);
    int moving = 0;
    for (int l = 0; l < width; ++l) moving += block.state[l] == lanes::moving;
    if (moving == 0) return;
  }
}

/// R_i of a cell where Newton's method is not to be trusted: collapsed, folded, flat or far from before.
[[gnu::noinline]] void fit_with_care(const Arrays& in, int i, Ascent& block, int lane) {
  Eigen::Matrix3d A;
  for (int k = 0; k < 9; ++k) A(k) = block.A.entry[k][lane];
  const Eigen::Matrix3d previous = Eigen::Map<const Eigen::Matrix3d>(in.rotation(i));
  const bool has_shape = A.norm() > collapsed * in.cells.moments[i].size;
  const Eigen::Matrix3d R = has_shape ? best_rotation(A, previous) : previous;
  for (int k = 0; k < 9; ++k) block.R.entry[k][lane] = R(k);
}

/// S_i of a coordinate k, from the rows k of A and R.
[[gnu::always_inline]] inline double axis_scale(const Vec& a, const Vec& r, const RestMoments& C,
                                                double drawn, double epsilon) {
  const Vec Cr{C.xx * r.x + C.xy * r.y + C.zx * r.z, C.xy * r.x + C.yy * r.y + C.yz * r.z,
               C.zx * r.x + C.yz * r.y + C.zz * r.z};
  const double denominator = dot(r, Cr) + epsilon * C.trace();
  return denominator < undetermined * C.trace() ? 1 : (dot(a, r) + epsilon * drawn) / denominator;
}

/// S_i of a cell whose R_i is known.
[[gnu::always_inline]] inline void fit_scale(const Arrays& in, int i, const Ascent& block, int lane) {
  const RestMoments& C = in.cells.moments[i];
  const auto &A = block.A.entry, &R = block.R.entry;
  double* S = in.S + 3 * static_cast<std::ptrdiff_t>(i);
  double trace = 0;  // of A Rᵀ, Σ ω e′ · R e
  for (int k = 0; k < 9; ++k) trace += A[k][lane] * R[k][lane];
  const bool is_fitted = in.options.local_scale != LocalScale::none && C.trace() > 0;
  const double uniform = is_fitted ? trace / C.trace() : 1;
  for (int c = 0; c < 3; ++c) S[c] = uniform;
  if (!is_fitted || in.options.local_scale == LocalScale::uniform) return;
  for (int c = 0; c < 3; ++c) {
    const Vec a{A[c][lane], A[3 + c][lane], A[6 + c][lane]}, r{R[c][lane], R[3 + c][lane], R[6 + c][lane]};
    S[c] = axis_scale(a, r, C, trace, in.options.epsilon);
  }
}

FLEXKEY_CLONES void fit_cells(const Arrays& in, int begin, int end) {
  Ascent block{};
  for (int first = begin; first < end; first += width) {
    const int count = std::min(width, end - first);
    load(in, first, count, block);
    ascend(block);
    for (int l = 0; l < count; ++l) {
      if (block.state[l] != lanes::settled) fit_with_care(in, first + l, block, l);
    }
    for (int l = 0; l < count; ++l) {
      for (int k = 0; k < 9; ++k) in.rotation(first + l)[k] = block.R.entry[k][l];
    }
    for (int l = 0; l < count; ++l) fit_scale(in, first + l, block, l);
  }
}

}  // namespace

void local_step(const CellTables& cells, const DeformOptions& options, const Positions& positions,
                Transforms& transforms) {
  if (cells.fitted() == 0) return;
  const Arrays arrays{cells, options, positions.data(), transforms.rotations.data()->data(),
                      transforms.scales.data()};
  const int count = cells.fitted();
  tbb::parallel_for(0, (count + grain - 1) / grain,
                    [&](int task) { fit_cells(arrays, task * grain, std::min(count, (task + 1) * grain)); });
}

}  // namespace flexkey
