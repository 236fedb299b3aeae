#pragma once

/// Best rotations of several cells at once, a cell a lane. These functions are inlined into loops over the
/// lanes that the compiler turns into vector instructions: plain doubles, selects in place of branches.
namespace flexkey::lanes {

constexpr int width = 8;

using Lane = double[width];  // a number of every cell

/// A 3 x 3 matrix of every cell, by columns.
struct Matrices {
  Lane entry[9];
};

struct Vec {
  double x, y, z;
};

/// A matrix of one cell: its columns.
struct Mat {
  Vec x, y, z;
};

[[gnu::always_inline]] inline double dot(const Vec& a, const Vec& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

[[gnu::always_inline]] inline Vec cross(const Vec& a, const Vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

[[gnu::always_inline]] inline Vec times(const Mat& m, const Vec& v) {
  return {m.x.x * v.x + m.y.x * v.y + m.z.x * v.z, m.x.y * v.x + m.y.y * v.y + m.z.y * v.z,
          m.x.z * v.x + m.y.z * v.y + m.z.z * v.z};
}

[[gnu::always_inline]] inline Vec transposed_times(const Mat& m, const Vec& v) {
  return {dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}

[[gnu::always_inline]] inline Vec select(bool first, const Vec& a, const Vec& b) {
  return {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
}

[[gnu::always_inline]] inline Mat load(const Matrices& from, int lane) {
  const auto& e = from.entry;
  return {{e[0][lane], e[1][lane], e[2][lane]},
          {e[3][lane], e[4][lane], e[5][lane]},
          {e[6][lane], e[7][lane], e[8][lane]}};
}

[[gnu::always_inline]] inline void store(const Vec& column, Lane* entry, int lane) {
  entry[0][lane] = column.x;
  entry[1][lane] = column.y;
  entry[2][lane] = column.z;
}

/// What has become of a cell.
constexpr double settled = 0, moving = 1, doubtful = 2;

/// The cells of a block, and Newton's method on their rotations.
struct Ascent {
  Matrices A, R;
  Lane state;
  Lane least;  // a moment smaller than this is rounding noise

  void step(int lane);
};

/// The rotation of the quaternion (1, v), normalised, less ½ (RᵀR − 1): R times it is a rotation again,
/// whatever rounding had made of R.
[[gnu::always_inline]] inline Mat turn(const Vec& v, const Mat& R) {
  const double s = 2 / (1 + dot(v, v)), one = 1.5 - s * dot(v, v);
  const double xy = s * v.x * v.y - 0.5 * dot(R.x, R.y);
  const double yz = s * v.y * v.z - 0.5 * dot(R.y, R.z);
  const double zx = s * v.z * v.x - 0.5 * dot(R.z, R.x);
  return {{one + s * v.x * v.x - 0.5 * dot(R.x, R.x), xy + s * v.z, zx - s * v.y},
          {xy - s * v.z, one + s * v.y * v.y - 0.5 * dot(R.y, R.y), yz + s * v.x},
          {zx + s * v.y, yz - s * v.x, one + s * v.z * v.z - 0.5 * dot(R.z, R.z)}};
}

/// A step of the method as best_rotation takes it: with M = Rᵀ A, H = (tr M) 1 − sym M and w = −H⁻¹ axial(M),
/// R becomes R exp [w]. A cell whose H is not clearly positive definite becomes doubtful.
[[gnu::always_inline]] inline void Ascent::step(int lane) {
  constexpr double roundness = 1e-7;  // of H: det over (tr)³, at most 1/27
  constexpr double close = 1e-14;     // radians, of what is left after the step
  const Mat a = load(A, lane), r = load(R, lane);
  const Mat M{transposed_times(r, a.x), transposed_times(r, a.y), transposed_times(r, a.z)};
  const double trace = M.x.x + M.y.y + M.z.z, cube = 8 * trace * trace * trace;
  const double xy = -0.5 * (M.x.y + M.y.x), yz = -0.5 * (M.y.z + M.z.y), zx = -0.5 * (M.z.x + M.x.z);
  const Mat H{{trace - M.x.x, xy, zx}, {xy, trace - M.y.y, yz}, {zx, yz, trace - M.z.z}};
  const Mat adjugate{cross(H.y, H.z), cross(H.z, H.x), cross(H.x, H.y)};
  const double det = dot(H.x, adjugate.x);
  const bool definite = (H.x.x > 0) & (adjugate.z.z > 0) & (det > roundness * cube) & (trace > least[lane]);

  const Vec axial{M.z.y - M.y.z, M.x.z - M.z.x, M.y.x - M.x.y};
  const Vec w = times(adjugate, axial);  // -det times
  const double half = -0.5 / det;
  const Vec v{half * w.x, half * w.y, half * w.z};
  const Mat Q = turn(v, r);
  const bool moves = (state[lane] == moving) & definite;
  store(select(moves, times(r, Q.x), r.x), R.entry, lane);
  store(select(moves, times(r, Q.y), r.y), R.entry + 3, lane);
  store(select(moves, times(r, Q.z), r.z), R.entry + 6, lane);

  // The third order of the ascent is at most |w|² |axial|, so that |w|³ |H| / λ_min bounds what is left; and
  // λ_min is at least 4 det / (tr H)².
  const double square = 4 * dot(v, v), bound = 4 * close * det;
  const bool is_close = square * square * square * cube * cube <= bound * bound;
  const double next = definite ? (is_close ? settled : moving) : doubtful;
  state[lane] = state[lane] == moving ? next : state[lane];
}

}  // namespace flexkey::lanes
