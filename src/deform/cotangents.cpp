#include "flexkey/deform/cotangents.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "flexkey/deform/fans.h"
#include "flexkey/deform/intrinsic_delaunay.h"

namespace flexkey {
namespace {

/// The least thickness that a triangle counts with: its double area over its longest side squared. Stiffer
/// slivers would drown their cells: with a few percent of them λ = 0 no longer converges.
double least_thickness(Weights weights) {
  return weights == Weights::cotangent ? 1e-4 : 5e-3;
}

/// What the cotangents at a triangle's corners are a fraction of, and its double area.
struct Fractions {
  std::array<double, 3> numerators;  // the inner product of the sides that meet there, mesh units squared
  double double_area = 0;
};

Fractions in_space(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, bc = c - b, ca = a - c;
  return {{-ab.dot(ca), -bc.dot(ab), -ca.dot(bc)}, ab.cross(ca).norm()};
}

Fractions by_lengths(const std::array<double, 3>& lengths) {
  const double a = lengths[0] * lengths[0], b = lengths[1] * lengths[1], c = lengths[2] * lengths[2];
  return {{(b + c - a) / 2, (c + a - b) / 2, (a + b - c) / 2}, double_area(lengths)};
}

/// Scaling all three cotangents alike keeps the triangle's share of L positive semidefinite.
std::array<double, 3> half_cotangents(const Fractions& at, double thickness) {
  const auto [a, b, c] = at.numerators;
  const double longest = std::max({a + b, b + c, c + a});  // squared
  if (longest == 0) return {0, 0, 0};
  const double twice = 2 * std::max(at.double_area, thickness * longest);
  return {a / twice, b / twice, c / twice};
}

}  // namespace

std::vector<WeightedTriangle> cotangent_triangles(const Mesh& mesh, Weights weights) {
  const double thickness = least_thickness(weights);
  std::vector<WeightedTriangle> triangles;
  if (weights == Weights::intrinsic_delaunay) {
    for (const auto& [corners, lengths] : intrinsic_delaunay(mesh)) {
      triangles.push_back({corners, half_cotangents(by_lengths(lengths), thickness)});
    }
    return triangles;
  }
  triangles.reserve(static_cast<std::size_t>(mesh.face_count()));
  const Positions& p = mesh.positions;
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const auto& [corners, share] : fan_triangles(mesh.face(f))) {
      const Fractions at = in_space(p.row(corners[0]), p.row(corners[1]), p.row(corners[2]));
      const auto [a, b, c] = half_cotangents(at, thickness);
      triangles.push_back({corners, {share * a, share * b, share * c}, share});
    }
  }
  return triangles;
}

}  // namespace flexkey
