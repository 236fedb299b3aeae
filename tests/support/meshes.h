#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "flexkey/mesh/mesh.h"

/// Small meshes, built in code.
namespace flexkey::meshes {

inline Mesh make_mesh(const std::vector<Vec3>& points, const std::vector<std::vector<int>>& faces) {
  Mesh mesh;
  mesh.positions.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t v = 0; v < points.size(); ++v) {
    mesh.positions.row(static_cast<Eigen::Index>(v)) = points[v].transpose();
  }
  for (const std::vector<int>& face : faces) mesh.add_face(face);
  return mesh;
}

/// A flat sheet in z = 0 of nx by ny unit quads, vertex (x, y) at x + (nx + 1) y.
inline Mesh grid(int nx, int ny) {
  std::vector<Vec3> points;
  std::vector<std::vector<int>> faces;
  for (int y = 0; y <= ny; ++y) {
    for (int x = 0; x <= nx; ++x) points.emplace_back(x, y, 0);
  }
  for (int y = 0; y < ny; ++y) {
    for (int x = 0; x < nx; ++x) {
      const int v = x + (nx + 1) * y;
      faces.push_back({v, v + 1, v + nx + 2, v + nx + 1});
    }
  }
  return make_mesh(points, faces);
}

/// The closed surface of nx by ny by nz unit cubes in quads, from the origin upwards.
inline Mesh bar(int nx, int ny, int nz) {
  const std::array<int, 3> size{nx, ny, nz};
  std::map<std::array<int, 3>, int> number;
  std::vector<Vec3> points;
  std::vector<std::vector<int>> faces;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [place, is_new] = number.try_emplace(at, static_cast<int>(points.size()));
    if (is_new) points.emplace_back(at[0], at[1], at[2]);
    return place->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const int side : {0, size[axis]}) {
      for (int a = 0; a < size[u]; ++a) {
        for (int b = 0; b < size[v]; ++b) {
          const auto corner = [&](int da, int db) {
            std::array<int, 3> at{};
            at[axis] = side;
            at[u] = a + da;
            at[v] = b + db;
            return vertex(at);
          };
          if (side > 0) {
            faces.push_back({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
          } else {
            faces.push_back({corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)});
          }
        }
      }
    }
  }
  return make_mesh(points, faces);
}

inline Mesh cube() {
  return bar(1, 1, 1);
}

inline Mesh tetrahedron() {
  return make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                   {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

/// Every polygon as its fan from its first corner.
inline Mesh triangulated(const Mesh& mesh) {
  Mesh result;
  result.positions = mesh.positions;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      result.add_face(std::array<int, 3>{face[0], face[k], face[k + 1]});
    }
  }
  return result;
}

/// Each triangle in four, new vertices at the middles of the edges, all on the unit sphere.
inline Mesh split_on_sphere(const Mesh& mesh) {
  std::vector<Vec3> points;
  for (Eigen::Index v = 0; v < mesh.positions.rows(); ++v) points.emplace_back(mesh.positions.row(v));
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [place, is_new] =
        middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(points.size()));
    if (is_new) points.push_back((mesh.positions.row(a) + mesh.positions.row(b)).transpose().normalized());
    return place->second;
  };
  std::vector<std::vector<int>> faces;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const int a = mesh.face(f)[0], b = mesh.face(f)[1], c = mesh.face(f)[2];
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    faces.insert(faces.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  return make_mesh(points, faces);
}

/// A sphere of radius 1: an octahedron whose triangles are split in four `level` times.
inline Mesh sphere(int level) {
  Mesh mesh =
      make_mesh({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
  for (int k = 0; k < level; ++k) mesh = split_on_sphere(mesh);
  return mesh;
}

/// Both meshes in one, the vertices of `b` after those of `a`.
inline Mesh joined(const Mesh& a, const Mesh& b) {
  Mesh result = a;
  result.positions.conservativeResize(a.vertex_count() + b.vertex_count(), 3);
  result.positions.bottomRows(b.vertex_count()) = b.positions;
  for (int f = 0; f < b.face_count(); ++f) {
    std::vector<int> face(b.face(f).begin(), b.face(f).end());
    for (int& v : face) v += a.vertex_count();
    result.add_face(face);
  }
  return result;
}

/// p -> linear p + shift of every row.
inline Positions moved(const Positions& positions, const Eigen::Matrix3d& linear, const Vec3& shift) {
  return (positions * linear.transpose()).rowwise() + shift.transpose();
}

inline Eigen::Matrix3d turn(double degrees, const Vec3& axis) {
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized()).toRotationMatrix();
}

/// The vertices whose coordinate along `axis` lies in [low, high], in increasing order.
inline std::vector<int> between(const Mesh& mesh, int axis, double low, double high) {
  std::vector<int> vertices;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.positions(v, axis) >= low && mesh.positions(v, axis) <= high) vertices.push_back(v);
  }
  return vertices;
}

/// A mesh with smooth bumps, so that no symmetry hides a fault.
inline Mesh bumpy(Mesh mesh, double height) {
  for (Eigen::Index v = 0; v < mesh.positions.rows(); ++v) {
    const Vec3 p = mesh.positions.row(v);
    const Vec3 bump(std::sin(1.3 * p.y() + 0.4 * p.z()), std::cos(0.9 * p.x() - p.z()),
                    std::sin(1.1 * p.x() + p.y()));
    mesh.positions.row(v) += height * bump.transpose();
  }
  return mesh;
}

}  // namespace flexkey::meshes
