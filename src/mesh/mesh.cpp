#include "flexkey/mesh/mesh.h"

#include <Eigen/Geometry>

namespace flexkey {

void Mesh::add_face(std::span<const int> vertices) {
  if (face_offsets.empty()) face_offsets.push_back(0);
  corners.insert(corners.end(), vertices.begin(), vertices.end());
  face_offsets.push_back(static_cast<int>(corners.size()));
}

Bounds bounds_of(const Positions& positions) {
  if (positions.rows() == 0) return {};
  return {positions.colwise().minCoeff().transpose(), positions.colwise().maxCoeff().transpose()};
}

Positions vertex_normals(const Mesh& mesh, const Positions& positions) {
  Positions normals = Positions::Zero(positions.rows(), 3);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    const Vec3 origin = positions.row(face[0]).transpose();
    Vec3 area = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      const Vec3 a = positions.row(face[k]).transpose() - origin;
      const Vec3 b = positions.row(face[k + 1]).transpose() - origin;
      area += 0.5 * a.cross(b);
    }
    for (const int v : face) normals.row(v) += area.transpose();
  }
  for (Eigen::Index v = 0; v < normals.rows(); ++v) {
    const double length = normals.row(v).norm();
    if (length > 0) {
      normals.row(v) /= length;
    } else {
      normals.row(v) = Vec3::UnitY().transpose();
    }
  }
  return normals;
}

}  // namespace flexkey
