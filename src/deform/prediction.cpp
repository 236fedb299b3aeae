#include "flexkey/deform/prediction.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

#include "flexkey/deform/dispatch.h"
#include "flexkey/deform/surface_order.h"

namespace flexkey {
namespace {

/// L_ff, and a right-hand side a handle.
struct HarmonicSystem {
  Eigen::SparseMatrix<double> L_ff;
  Eigen::MatrixXd b;
};

/// -L_fc 1_h of each handle h, free x #handles.
Eigen::MatrixXd handle_columns(const Cells& clamped, const Patch& patch, const std::vector<int>& owner,
                               int handle_count) {
  std::vector<bool> is_free(owner.size(), false);
  for (int i = 0; i < patch.free; ++i) is_free[patch.vertices[i]] = true;
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(patch.free, handle_count);
  for (int i = 0; i < patch.free; ++i)
    for (const auto [j, weight] : clamped.of(patch.vertices[i]))
      if (!is_free[j] && owner[j] >= 0) b(i, owner[j]) += weight;
  return b;
}

HarmonicSystem assemble(const Cells& clamped, const Patch& patch, const std::vector<int>& owner,
                        int handle_count) {
  std::vector<int> place(owner.size(), -1);  // in F
  for (int i = 0; i < patch.free; ++i) place[patch.vertices[i]] = i;
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < patch.free; ++i) {
    double diagonal = 0;
    for (const auto [j, weight] : clamped.of(patch.vertices[i])) {
      diagonal += weight;
      if (place[j] >= 0) entries.emplace_back(i, place[j], -weight);
    }
    entries.emplace_back(i, i, diagonal);
  }
  HarmonicSystem system{Eigen::SparseMatrix<double>(patch.free, patch.free),
                        handle_columns(clamped, patch, owner, handle_count)};
  system.L_ff.setFromTriplets(entries.begin(), entries.end());
  return system;
}

/// The springs draw to 1 for their own handle and to 0 for every other.
void hold_softly(const std::vector<SoftHandle>& soft, HarmonicSystem& system) {
  const Eigen::VectorXd stiffness = soft_stiffness(system.L_ff, soft);
  for (std::size_t h = 0; h < soft.size(); ++h) {
    for (const int v : soft[h].vertices) {
      system.L_ff.coeffRef(v, v) += stiffness(static_cast<Eigen::Index>(h));
      system.b(v, soft[h].handle) += stiffness(static_cast<Eigen::Index>(h));
    }
  }
}

/// log Q; short turns, which nearly all are, by the first terms of its series.
Vec3 rotation_vector(const Eigen::Matrix3d& Q) {
  constexpr double is_short = 1e-4;  // sin²
  const Vec3 a(Q(2, 1) - Q(1, 2), Q(0, 2) - Q(2, 0), Q(1, 0) - Q(0, 1));
  const double sine_squared = a.squaredNorm() / 4;
  if (sine_squared < is_short && Q.trace() > 0)
    return a / 2 * (1 + sine_squared * (1.0 / 6 + sine_squared * (3.0 / 40)));
  const Eigen::AngleAxisd turn(Q);
  return turn.angle() * turn.axis();
}

/// exp [v] by Rodrigues' formula, short turns by the first terms of its series; 1 for v = 0, to the last bit.
[[gnu::always_inline]] inline void turn(const double* v, double* Q) {
  constexpr double is_short = 1e-2;  // radians²
  const double xx = v[0] * v[0], yy = v[1] * v[1], zz = v[2] * v[2], x = xx + yy + zz;
  // sin θ / θ and (1 − cos θ) / θ² of x = θ².
  double a = 1 - x * (1.0 / 6 - x * (1.0 / 120 - x * (1.0 / 5040 - x * (1.0 / 362880))));
  double b = 1.0 / 2 - x * (1.0 / 24 - x * (1.0 / 720 - x * (1.0 / 40320 - x * (1.0 / 3628800))));
  if (x > is_short) {
    const double angle = std::sqrt(x);
    a = std::sin(angle) / angle;
    b = (1 - std::cos(angle)) / x;
  }
  const double xy = b * v[0] * v[1], yz = b * v[1] * v[2], zx = b * v[2] * v[0];
  Q[0] = 1 - b * (yy + zz), Q[1] = xy + a * v[2], Q[2] = zx - a * v[1];
  Q[3] = xy - a * v[2], Q[4] = 1 - b * (zz + xx), Q[5] = yz + a * v[0];
  Q[6] = zx + a * v[1], Q[7] = yz - a * v[0], Q[8] = 1 - b * (xx + yy);
}

using Four = double __attribute__((vector_size(4 * sizeof(double))));  // x, y, z and a spare

/// `to` = Q `from`, 3 x 3 by columns.
[[gnu::always_inline]] inline void multiply(const double* Q, const double* from, double* to) {
  const Four x{Q[0], Q[1], Q[2]}, y{Q[3], Q[4], Q[5]}, z{Q[6], Q[7], Q[8]};
  for (int c = 0; c < 9; c += 3) {
    const Four column = x * from[c] + y * from[c + 1] + z * from[c + 2];
    for (int r = 0; r < 3; ++r) to[c + r] = column[r];
  }
}

FLEXKEY_CLONES void turn_all(const double* vectors, const double* from, double* to, int count) {
  for (int i = 0; i < count; ++i) {
    double Q[9];
    turn(vectors + 3 * static_cast<std::ptrdiff_t>(i), Q);
    multiply(Q, from + 9 * static_cast<std::ptrdiff_t>(i), to + 9 * static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace

Eigen::MatrixXd harmonic_weights(const Cells& clamped, const Patch& patch, const std::vector<int>& owner,
                                 int handle_count, const Ties& ties, const Factor* factor) {
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(patch.fitted, handle_count);
  for (int i = patch.free; i < patch.fitted; ++i) {
    const int handle = owner[patch.vertices[i]];
    if (handle >= 0) weights(i, handle) = 1;
  }
  if (factor) {
    weights.topRows(patch.free) = factor->solve(handle_columns(clamped, patch, owner, handle_count));
    return weights;
  }
  HarmonicSystem system = assemble(clamped, patch, owner, handle_count);
  hold_softly(ties.soft, system);
  if (ties.rigid.empty()) {
    weights.topRows(patch.free) = factor_in_order(system.L_ff, ties.places).solve(system.b);
  } else {
    const Eigen::SparseMatrix<double> C = summing_matrix(ties.rigid, patch.free);
    const Eigen::MatrixXd b = C.transpose() * system.b;
    const Eigen::SparseMatrix<double> reduced = C.transpose() * system.L_ff * C;
    weights.topRows(patch.free) = C * factor_in_order(reduced, places_of_unknowns(C, ties.places)).solve(b);
  }
  return weights;
}

Positions deviations(const Transforms& found, const Transforms& predicted) {
  Positions vectors(static_cast<Eigen::Index>(found.rotations.size()), 3);
  tbb::parallel_for(std::size_t{0}, found.rotations.size(), [&](std::size_t i) {
    const Eigen::Matrix3d turn = found.rotations[i] * predicted.rotations[i].transpose();
    vectors.row(static_cast<Eigen::Index>(i)) = rotation_vector(turn).transpose();
  });
  return vectors;
}

Transforms turned_further(const Transforms& transforms, const Positions& vectors) {
  constexpr int grain = 512;  // cells a task
  const int count = static_cast<int>(transforms.rotations.size());
  Transforms turned{std::vector<Eigen::Matrix3d>(transforms.rotations.size()), transforms.scales};
  tbb::parallel_for(0, (count + grain - 1) / grain, [&](int task) {
    const int first = task * grain;
    turn_all(vectors.data() + 3 * static_cast<std::ptrdiff_t>(first), transforms.rotations[first].data(),
             turned.rotations[first].data(), std::min(grain, count - first));
  });
  return turned;
}

double recurrence(const Positions& found, const Positions& expected) {
  const double size = expected.squaredNorm();
  return size > 0 ? std::clamp(found.cwiseProduct(expected).sum() / size, 0.0, most_recurrence)
                  : most_recurrence;
}

}  // namespace flexkey
