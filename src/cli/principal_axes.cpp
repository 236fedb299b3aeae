#include "cli/principal_axes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "flexkey/mesh/error.h"

namespace flexkey::cli {
namespace {

bool is_taken(const Mesh& mesh, int f, const std::vector<bool>& taken) {
  const std::span<const int> face = mesh.face(f);
  return std::all_of(face.begin(), face.end(), [&](int v) { return taken[static_cast<std::size_t>(v)]; });
}

/// Half the sum of the cross products around a face.
double area_of(const Mesh& mesh, int f) {
  const std::span<const int> face = mesh.face(f);
  const Vec3 origin = mesh.positions.row(face[0]);
  Vec3 area = Vec3::Zero();
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Vec3 a = mesh.positions.row(face[k]), b = mesh.positions.row(face[(k + 1) % face.size()]);
    area += (a - origin).cross(b - origin) / 2;
  }
  return area.norm();
}

/// Each vertex's part of the area of its faces, #V; the sum is 1.
Eigen::VectorXd vertex_weights(const Mesh& surface, const std::vector<bool>& taken) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(surface.vertex_count());
  for (int f = 0; f < surface.face_count(); ++f) {
    if (!is_taken(surface, f, taken)) continue;
    const std::span<const int> face = surface.face(f);
    for (const int v : face) weights[v] += area_of(surface, f) / static_cast<double>(face.size());
  }
  if (!(weights.sum() > 0)) throw InputError("the mesh has no area: there is nothing to animate");
  return weights / weights.sum();
}

/// The coordinate axes, that of the largest variance first.
Eigen::Matrix3d coordinate_axes(const Eigen::Matrix3d& covariance) {
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return covariance(a, a) > 1.001 * covariance(b, b); });
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
  for (int k = 0; k < 3; ++k) axes(order[static_cast<std::size_t>(k)], k) = 1;
  return axes;
}

Eigen::Matrix3d axes_of(const Eigen::Matrix3d& covariance) {
  constexpr double alike = 0.8;  // of two variances: their axes might as well be any others between them
  const double near = std::cos(0.3);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Vec3 variances = solver.eigenvalues();  // the smallest first
  const Eigen::Matrix3d axes = solver.eigenvectors().rowwise().reverse();
  const bool is_round = variances[0] > alike * variances[1] || variances[1] > alike * variances[2];
  const bool is_aligned = axes.cwiseAbs().colwise().maxCoeff().minCoeff() > near;
  return is_round || is_aligned ? coordinate_axes(covariance) : axes;
}

}  // namespace

PrincipalAxes principal_axes(const Mesh& surface, const std::vector<bool>& taken) {
  const Eigen::VectorXd weights = vertex_weights(surface, taken);
  PrincipalAxes result;
  result.centre = surface.positions.transpose() * weights;
  const Positions from_centre = surface.positions.rowwise() - result.centre.transpose();
  result.axes = axes_of(from_centre.transpose() * weights.asDiagonal() * from_centre);
  const Positions along = from_centre * result.axes;
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  for (int v = 0; v < surface.vertex_count(); ++v) {
    if (!taken[static_cast<std::size_t>(v)]) continue;
    low = low.cwiseMin(along.row(v).transpose());
    high = high.cwiseMax(along.row(v).transpose());
  }
  result.extents = high - low;
  return result;
}

}  // namespace flexkey::cli
