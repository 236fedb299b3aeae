#pragma once

#include <vector>

#include "flexkey/deform/cell_tables.h"
#include "flexkey/deform/options.h"

/// The fit of a block of cells at once, a cell a lane: every number here is one of each cell. All of it is
/// inlined, so that it is compiled for the CPU of the function that uses it.
namespace flexkey::lanes {

// Wider vectors than a CPU has registers for cost more than they save; a portable build's CPU is not known.
#ifdef __AVX512F__
constexpr int width = 8;
#else
constexpr int width = 4;
#endif

using Lane = double __attribute__((vector_size(width * sizeof(double))));
using Mask = long long __attribute__((vector_size(width * sizeof(double))));  // of each lane 0 or −1

struct Vec {
  Lane x, y, z;
};

constexpr double collapsed = 1e-14;  // a cell shrunk to this share of its rest size is rounding noise

/// A matrix by its columns.
struct Mat {
  Vec x, y, z;
};

[[gnu::always_inline]] inline Lane load(const double* from) {
  using Loose __attribute__((aligned(sizeof(double)), may_alias)) = Lane;
  return *reinterpret_cast<const Loose*>(from);
}

[[gnu::always_inline]] inline Lane dot(const Vec& a, const Vec& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// tr(Aᵀ B).
[[gnu::always_inline]] inline Lane dot(const Mat& A, const Mat& B) {
  return dot(A.x, B.x) + dot(A.y, B.y) + dot(A.z, B.z);
}

[[gnu::always_inline]] inline Vec cross(const Vec& a, const Vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

[[gnu::always_inline]] inline Vec times(const Mat& A, const Vec& v) {
  return {A.x.x * v.x + A.y.x * v.y + A.z.x * v.z, A.x.y * v.x + A.y.y * v.y + A.z.y * v.z,
          A.x.z * v.x + A.y.z * v.y + A.z.z * v.z};
}

[[gnu::always_inline]] inline Mat times(const Mat& A, const Mat& B) {
  return {times(A, B.x), times(A, B.y), times(A, B.z)};
}

/// Aᵀ B.
[[gnu::always_inline]] inline Mat transposed_times(const Mat& A, const Mat& B) {
  return {{dot(A.x, B.x), dot(A.y, B.x), dot(A.z, B.x)},
          {dot(A.x, B.y), dot(A.y, B.y), dot(A.z, B.y)},
          {dot(A.x, B.z), dot(A.y, B.z), dot(A.z, B.z)}};
}

[[gnu::always_inline]] inline Vec select(const Mask& where, const Vec& a, const Vec& b) {
  return {where ? a.x : b.x, where ? a.y : b.y, where ? a.z : b.z};
}

[[gnu::always_inline]] inline Mat select(const Mask& where, const Mat& A, const Mat& B) {
  return {select(where, A.x, B.x), select(where, A.y, B.y), select(where, A.z, B.z)};
}

/// The vector of one cell, three numbers in memory, into its lane.
[[gnu::always_inline]] inline void put(const double* from, Vec& to, int lane) {
  to.x[lane] = from[0];
  to.y[lane] = from[1];
  to.z[lane] = from[2];
}

[[gnu::always_inline]] inline void take(const Vec& from, int lane, double* to) {
  to[0] = from.x[lane];
  to[1] = from.y[lane];
  to[2] = from.z[lane];
}

/// The matrix of one cell, nine numbers by columns, into its lane.
[[gnu::always_inline]] inline void put(const double* from, Mat& to, int lane) {
  put(from, to.x, lane);
  put(from + 3, to.y, lane);
  put(from + 6, to.z, lane);
}

[[gnu::always_inline]] inline void take(const Mat& from, int lane, double* to) {
  take(from.x, lane, to);
  take(from.y, lane, to + 3);
  take(from.z, lane, to + 6);
}

/// The rotation of the quaternion (1, v), normalised, less ½ (RᵀR − 1): R times it is a rotation again,
/// whatever rounding had made of R.
[[gnu::always_inline]] inline Mat turn(const Vec& v, const Mat& R) {
  const Lane s = 2 / (1 + dot(v, v)), one = 1.5 - s * dot(v, v);
  const Lane xy = s * v.x * v.y - 0.5 * dot(R.x, R.y);
  const Lane yz = s * v.y * v.z - 0.5 * dot(R.y, R.z);
  const Lane zx = s * v.z * v.x - 0.5 * dot(R.z, R.x);
  return {{one + s * v.x * v.x - 0.5 * dot(R.x, R.x), xy + s * v.z, zx - s * v.y},
          {xy - s * v.z, one + s * v.y * v.y - 0.5 * dot(R.y, R.y), yz + s * v.x},
          {zx + s * v.y, yz - s * v.x, one + s * v.z * v.z - 0.5 * dot(R.z, R.z)}};
}

/// Newton's method on the rotations of a block, as best_rotation goes about it for one cell.
struct Ascent {
  Mat A, R;       // Σ ω e′ eᵀ, and the rotations as found so far
  Lane least;     // a tr(Rᵀ A) under this is rounding noise
  Mask moving;    // the cells that have not settled yet
  Mask doubtful;  // the cells that a step could not be trusted with

  /// A and R hold `count` cells. size: their Σ |ω| |e|².
  void begin(int count, const double* size);
  void step();
  bool is_done() const;
};

[[gnu::always_inline]] inline void Ascent::begin(int count, const double* size) {
  // The trace at the best R, the sum of the singular values, is at most √3 |A|. Its cube must be a number.
  least = 2 * collapsed * load(size) + 1e-100;
  for (int lane = 0; lane < width; ++lane) moving[lane] = lane < count ? -1 : 0;
  doubtful = Mask{};
}

/// With M = Rᵀ A, H = (tr M) 1 − sym M and w = −H⁻¹ axial(M), R becomes R exp [w]. A cell whose H is not
/// clearly positive definite is given up.
[[gnu::always_inline]] inline void Ascent::step() {
  constexpr double roundness = 1e-7;  // of H: det over (tr)³, at most 1/27
  constexpr double close = 1e-14;     // radians, of what is left after the step
  const Mat M = transposed_times(R, A);
  const Lane trace = M.x.x + M.y.y + M.z.z, cube = 8 * trace * trace * trace;
  const Lane xy = -0.5 * (M.x.y + M.y.x), yz = -0.5 * (M.y.z + M.z.y), zx = -0.5 * (M.z.x + M.x.z);
  const Mat H{{trace - M.x.x, xy, zx}, {xy, trace - M.y.y, yz}, {zx, yz, trace - M.z.z}};
  const Mat adjugate{cross(H.y, H.z), cross(H.z, H.x), cross(H.x, H.y)};
  const Lane det = dot(H.x, adjugate.x), over_det = 1 / det;
  const Mask definite = (H.x.x > 0) & (adjugate.z.z > 0) & (det > roundness * cube) & (trace > least);
  doubtful |= moving & ~definite;
  moving &= definite;

  const Vec axial{M.z.y - M.y.z, M.x.z - M.z.x, M.y.x - M.x.y};
  const Vec w = times(adjugate, axial);  // times −det
  const Lane half = -0.5 * over_det;
  const Vec v{half * w.x, half * w.y, half * w.z};
  R = select(moving, times(R, turn(v, R)), R);

  // The ascent's third order is at most |w|² |axial|, so that |w|³ |H| / λ_min bounds what is left; and
  // λ_min is at least 4 det / (tr H)².
  const Lane square = 4 * dot(v, v), steepness = cube * over_det / 4;
  moving &= square * square * square * steepness * steepness > close * close;
}

[[gnu::always_inline]] inline bool Ascent::is_done() const {
  long long left = 0;
  for (int lane = 0; lane < width; ++lane) left |= moving[lane];
  return left == 0;
}

/// S_i of kind `uniform`: Σ ω e′ · R e / Σ ω |e|². trace: the cells' Σ ω |e|².
[[gnu::always_inline]] inline Vec uniform_scales(const Mat& A, const Mat& R, const double* trace) {
  const Lane size = load(trace), s = size > 0 ? dot(A, R) / size : 1 + Lane{};
  return {s, s, s};
}

/// What the numbers of kind `axis` are made of: eq 8, drawn towards the uniform scale by epsilon.
struct AxisScale {
  Mat C;  // Σ ω e eᵀ, symmetric
  double epsilon;
  Lane size, drawn;  // Σ ω |e|², ε Σ ω e′ · R e

  /// s_k from the rows k of A and R.
  Lane of(const Vec& a, const Vec& r) const;
};

[[gnu::always_inline]] inline Lane AxisScale::of(const Vec& a, const Vec& r) const {
  constexpr double undetermined = 1e-12;  // share of Σ ω |e|²
  const Lane rotated = dot(r, times(C, r)) + epsilon * size;
  const Mask is_determined = (size > 0) & (rotated >= undetermined * size);
  return is_determined ? (dot(a, r) + drawn) / rotated : 1 + Lane{};
}

/// S_i of kind `axis` of the cells from `first` on.
[[gnu::always_inline]] inline Vec axis_scales(const Mat& A, const Mat& R, const RestMoments& rest, int first,
                                              double epsilon) {
  const auto at = [first](const std::vector<double>& values) { return values.data() + first; };
  const Lane xy = load(at(rest.xy)), yz = load(at(rest.yz)), zx = load(at(rest.zx));
  const Mat C{{load(at(rest.xx)), xy, zx}, {xy, load(at(rest.yy)), yz}, {zx, yz, load(at(rest.zz))}};
  const AxisScale scale{C, epsilon, load(at(rest.trace)), epsilon * dot(A, R)};
  return {scale.of({A.x.x, A.y.x, A.z.x}, {R.x.x, R.y.x, R.z.x}),
          scale.of({A.x.y, A.y.y, A.z.y}, {R.x.y, R.y.y, R.z.y}),
          scale.of({A.x.z, A.y.z, A.z.z}, {R.x.z, R.y.z, R.z.z})};
}

/// S_i of the cells from `first` on, whose R_i are known.
[[gnu::always_inline]] inline Vec best_scales(const Mat& A, const Mat& R, const RestMoments& rest, int first,
                                              const DeformOptions& options) {
  switch (options.local_scale) {
    case LocalScale::uniform:
      return uniform_scales(A, R, rest.trace.data() + first);
    case LocalScale::axis:
      return axis_scales(A, R, rest, first, options.epsilon);
    case LocalScale::none:
      break;
  }
  return {1 + Lane{}, 1 + Lane{}, 1 + Lane{}};
}

}  // namespace flexkey::lanes
