#include "flexkey/deform/vertex_areas.h"

#include <Eigen/Geometry>

#include "flexkey/deform/fans.h"

namespace flexkey {
namespace {

constexpr double least_area = 1e-6;  // of the mean

}  // namespace

Eigen::VectorXd vertex_areas(const Mesh& mesh) {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.vertex_count());
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const auto& [corners, share] : fan_triangles(mesh.face(f))) {
      const Vec3 a = mesh.positions.row(corners[0]), b = mesh.positions.row(corners[1]);
      const Vec3 c = mesh.positions.row(corners[2]);
      const double third = share * (b - a).cross(c - a).norm() / 6;
      for (const int v : corners) areas(v) += third;
    }
  }
  return areas;
}

Eigen::VectorXd row_weights(const Mesh& mesh) {
  const Eigen::VectorXd areas = vertex_areas(mesh);
  const double mean = areas.mean();
  if (!(mean > 0)) return Eigen::VectorXd::Ones(areas.size());
  return (mean / areas.array().max(least_area * mean)).matrix();
}

}  // namespace flexkey
