#include "flexkey/deform/rotation.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <optional>

namespace flexkey {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::Vector4d;

/// The vector a with a · w = tr(M [w]) for every w.
Vector3d axial(const Matrix3d& M) {
  return {M(1, 2) - M(2, 1), M(2, 0) - M(0, 2), M(0, 1) - M(1, 0)};
}

/// Newton's method on the rotations from `start`. With M = Rᵀ A, tr((R exp [w])ᵀ A) = tr M − a·w − ½ wᵀ H w,
/// a = axial(M) and H = (tr M) 1 − sym M. A critical point with H positive definite is the only maximum, so
/// nothing is returned where H is not clearly so or the steps do not settle.
std::optional<Quaterniond> ascend(const Matrix3d& A, Quaterniond q) {
  constexpr int most_steps = 8;
  constexpr double settled = 1e-6;    // radians; convergence is cubic, as tr([w]³ M) = 0 at the maximum
  constexpr double roundness = 1e-7;  // of H: det over (tr)³, at most 1/27
  for (int k = 0; k < most_steps; ++k) {
    const Matrix3d M = q.toRotationMatrix().transpose() * A;
    const Matrix3d H = M.trace() * Matrix3d::Identity() - 0.5 * (M + M.transpose());
    const double trace = H.trace(), det = H.determinant();
    const double minor = H(0, 0) * H(1, 1) - H(0, 1) * H(1, 0);
    const bool definite = H(0, 0) > 0 && minor > 0 && det > roundness * trace * trace * trace;
    if (!definite) return std::nullopt;
    const Vector3d w = -H.inverse() * axial(M);
    q = (q * Quaterniond(1, w.x() / 2, w.y() / 2, w.z() / 2)).normalized();
    if (w.norm() <= settled) return q;
  }
  return std::nullopt;
}

/// Davenport's K: tr(R(q)ᵀ A) = qᵀ K q for a unit quaternion q = (w, x, y, z).
Matrix4d davenport(const Matrix3d& A) {
  Matrix4d K;
  K(0, 0) = A.trace();
  K.block<3, 1>(1, 0) = -axial(A);
  K.block<1, 3>(0, 1) = K.block<3, 1>(1, 0).transpose();
  K.block<3, 3>(1, 1) = A + A.transpose() - A.trace() * Matrix3d::Identity();
  return K;
}

/// The best quaternions are the eigenvectors of K's largest eigenvalue; of these, the nearest to `previous`
/// is its projection onto their space.
Quaterniond nearest_best(const Matrix3d& A, const Quaterniond& previous) {
  constexpr double same = 1e-10;  // share of |K| within which eigenvalues count as equal
  const Matrix4d K = davenport(A);
  const Eigen::SelfAdjointEigenSolver<Matrix4d> eigen(K);
  const Vector4d start(previous.w(), previous.x(), previous.y(), previous.z());
  Vector4d projection = Vector4d::Zero();
  for (int k = 0; k < 4; ++k) {
    if (eigen.eigenvalues()(k) < eigen.eigenvalues()(3) - same * K.norm()) continue;
    projection += eigen.eigenvectors().col(k).dot(start) * eigen.eigenvectors().col(k);
  }
  const bool opposite = projection.norm() < 1e-8;  // half a turn from all of them: any is as near
  const Vector4d best = opposite ? Vector4d(eigen.eigenvectors().col(3)) : projection.normalized();
  return {best(0), best(1), best(2), best(3)};
}

}  // namespace

Matrix3d best_rotation(const Matrix3d& A, const Matrix3d& previous) {
  const double size = A.norm();
  if (!(size > 0) || !std::isfinite(size)) return previous;
  const Matrix3d unit = A / size;
  const Quaterniond start = Quaterniond(previous).normalized();
  const std::optional<Quaterniond> found = ascend(unit, start);
  return (found ? *found : nearest_best(unit, start)).toRotationMatrix();
}

}  // namespace flexkey
