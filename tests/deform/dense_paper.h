#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <set>
#include <vector>

#include "flexkey/deform/deformer.h"

/// The paper written down once more with dense matrices and loops over all pairs, to hold the program
/// against.
namespace flexkey::dense {

inline void add_triangle(const Positions& p, int a, int b, int c, double share, Eigen::MatrixXd& W) {
  const std::vector<int> corner{a, b, c};
  for (std::size_t k = 0; k < 3; ++k) {
    const int apex = corner[k], i = corner[(k + 1) % 3], j = corner[(k + 2) % 3];
    const Vec3 u = p.row(i) - p.row(apex), v = p.row(j) - p.row(apex);
    const double angle = std::acos(u.dot(v) / (u.norm() * v.norm()));
    W(i, j) += share / 2 / std::tan(angle);
    W(j, i) += share / 2 / std::tan(angle);
  }
}

/// ω of triangles and quads.
inline Eigen::MatrixXd weights(const Mesh& mesh, Weights kind) {
  const Eigen::Index n = mesh.vertex_count();
  Eigen::MatrixXd W = Eigen::MatrixXd::Zero(n, n), is_edge = W;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto v = mesh.face(f);
    for (const int a : v) {
      for (const int b : v) is_edge(a, b) = a != b;
    }
    if (v.size() == 3) {
      add_triangle(mesh.positions, v[0], v[1], v[2], 1, W);
    } else {
      add_triangle(mesh.positions, v[0], v[1], v[2], 0.5, W);
      add_triangle(mesh.positions, v[0], v[2], v[3], 0.5, W);
      add_triangle(mesh.positions, v[0], v[1], v[3], 0.5, W);
      add_triangle(mesh.positions, v[1], v[2], v[3], 0.5, W);
    }
  }
  const double floor = kind == Weights::clamped ? 1e-6 * W.sum() / is_edge.sum() : -HUGE_VAL;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) W(i, j) = is_edge(i, j) > 0 ? std::max(W(i, j), floor) : 0;
  }
  return W;
}

inline Eigen::MatrixXd laplacian(const Eigen::MatrixXd& W) {
  return Eigen::MatrixXd(W.rowwise().sum().asDiagonal()) - W;
}

/// R_i by singular values, unique on the cells of the tests.
inline Eigen::Matrix3d rotation(const Eigen::MatrixXd& W, const Positions& p, const Positions& p_deformed,
                                int i) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  for (int j = 0; j < W.rows(); ++j) {
    A += W(i, j) * (p_deformed.row(i) - p_deformed.row(j)).transpose() * (p.row(i) - p.row(j));
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  return svd.matrixU() * Vec3(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

/// S_i from the sums over edges as the design writes them.
inline Vec3 scale(const Eigen::MatrixXd& W, const Positions& p, const Positions& p_deformed, int i,
                  const DeformOptions& options) {
  const Eigen::Matrix3d R = rotation(W, p, p_deformed, i);
  Vec3 fit = Vec3::Zero(), size = Vec3::Zero();
  for (int j = 0; j < W.rows(); ++j) {
    const Vec3 Re = R * (p.row(i) - p.row(j)).transpose();
    const Vec3 e_deformed = (p_deformed.row(i) - p_deformed.row(j)).transpose();
    fit += W(i, j) * e_deformed.cwiseProduct(Re);
    size += W(i, j) * Re.cwiseProduct(Re);
  }
  if (options.local_scale == LocalScale::none) return Vec3::Ones();
  if (options.local_scale == LocalScale::uniform) return Vec3::Constant(fit.sum() / size.sum());
  const double e = options.epsilon;
  Vec3 s = (fit.array() + e * fit.sum()) / (size.array() + e * size.sum());
  for (int k = 0; k < 3; ++k) {
    if (e == 0 && size(k) < 1e-12 * size.sum()) s(k) = 1;
  }
  return s;
}

/// r of eq 4 for every vertex, fitted to p_deformed.
inline Positions right_hand_side(const Eigen::MatrixXd& W, const Positions& p, const Positions& p_deformed,
                                 const Eigen::VectorXd& lambda, const DeformOptions& options) {
  Positions r = Positions::Zero(p.rows(), 3);
  for (int i = 0; i < p.rows(); ++i) {
    const Eigen::Matrix3d R_i = rotation(W, p, p_deformed, i);
    const Eigen::Matrix3d T_i = scale(W, p, p_deformed, i, options).asDiagonal() * R_i;
    for (int j = 0; j < p.rows(); ++j) {
      if (W(i, j) == 0) continue;
      const Vec3 e = (p.row(i) - p.row(j)).transpose();
      const Eigen::Matrix3d R_j = rotation(W, p, p_deformed, j);
      r.row(i) += lambda(i) * W(i, j) / 2 * ((R_i + R_j) * e).transpose();
      r.row(i) += (1 - lambda(i)) * W(i, j) * (T_i * e).transpose();
    }
  }
  return r;
}

/// The p′ of eq 7 or eq 5 with `held` vertices where they are in p: least squares by a dense QR.
inline Positions solve(const Eigen::MatrixXd& W, const Positions& r, Positions p,
                       const std::vector<int>& held, System system) {
  const std::set<int> fixed(held.begin(), held.end());
  std::vector<int> free, rows;
  for (int v = 0; v < p.rows(); ++v) {
    if (!fixed.contains(v)) free.push_back(v);
  }
  for (int v = 0; v < p.rows(); ++v) {
    bool is_row = !fixed.contains(v);
    for (const int f : free) is_row = is_row || (system == System::least_squares && W(v, f) != 0);
    if (is_row) rows.push_back(v);
  }
  const Eigen::MatrixXd L = laplacian(W);
  const Eigen::MatrixXd L_f = L(rows, free), L_c = L(rows, held);
  const Eigen::MatrixXd b = Eigen::MatrixXd(r(rows, Eigen::all)) - L_c * Eigen::MatrixXd(p(held, Eigen::all));
  p(free, Eigen::all) = L_f.colPivHouseholderQr().solve(b);
  return p;
}

}  // namespace flexkey::dense
