#pragma once

#include <initializer_list>
#include <vector>

#include "flexkey/mesh/mesh.h"

namespace flexkey::test {

inline Mesh mesh_of(std::vector<Vec3> points, std::vector<std::vector<int>> faces) {
  Mesh mesh;
  mesh.positions.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t v = 0; v < points.size(); ++v)
    mesh.positions.row(static_cast<Eigen::Index>(v)) = points[v].transpose();
  for (const std::vector<int>& face : faces) mesh.add_face(face);
  return mesh;
}

/// n x n unit quads in the plane z = 0, vertex (i, j) at index i + (n + 1) j; outside is +z.
inline Mesh quad_grid(int n) {
  std::vector<Vec3> points;
  std::vector<std::vector<int>> faces;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) points.emplace_back(i, j, 0);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int v = i + (n + 1) * j;
      faces.push_back({v, v + 1, v + n + 2, v + n + 1});
    }
  return mesh_of(std::move(points), std::move(faces));
}

}  // namespace flexkey::test
