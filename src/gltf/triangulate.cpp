#include "flexkey/gltf/triangulate.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

using Triangle = std::array<int, 3>;
using Triangles = std::vector<Triangle>;
using Points2 = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

// Cutting ears takes time with the square of the corners.
constexpr int kMostEars = 10'000;

// A triangle of a fan that covers less than this share of the polygon is a sliver on collinear corners.
constexpr double kSliver = 1e-12;

Vec3 area_vector(const Positions& corners, const Triangle& t) {
  const Vec3 origin = corners.row(t[0]);
  return 0.5 * (corners.row(t[1]).transpose() - origin).cross(corners.row(t[2]).transpose() - origin);
}

Triangles fan(int corners) {
  Triangles triangles;
  for (int i = 1; i + 1 < corners; ++i) triangles.push_back({0, i, i + 1});
  return triangles;
}

Vec3 area_vector(const Positions& corners) {
  Vec3 sum = Vec3::Zero();
  for (const Triangle& t : fan(static_cast<int>(corners.rows()))) sum += area_vector(corners, t);
  return sum;
}

/// The smallest area among the triangles as a share of the polygon's, negative where one is folded over.
double smallest_share(const Positions& corners, const Triangles& triangles) {
  const Vec3 area = area_vector(corners);
  double smallest = 1;
  for (const Triangle& t : triangles) {
    smallest = std::min(smallest, area_vector(corners, t).dot(area) / area.squaredNorm());
  }
  return smallest;
}

Triangles split_quad(const Positions& corners) {
  Triangles shorter = {{0, 1, 2}, {0, 2, 3}};
  Triangles longer = {{0, 1, 3}, {1, 2, 3}};
  const double first = (corners.row(0) - corners.row(2)).squaredNorm();
  const double second = (corners.row(1) - corners.row(3)).squaredNorm();
  if (second < first) std::swap(shorter, longer);
  const bool folds = smallest_share(corners, shorter) <= 0 && smallest_share(corners, longer) > 0;
  return folds ? longer : shorter;
}

/// The polygon seen along its normal, so that it turns counter-clockwise.
Points2 flatten(const Positions& corners) {
  const Vec3 normal = area_vector(corners).normalized();
  Eigen::Matrix<double, 3, 2> axes;
  axes.col(0) = normal.unitOrthogonal();
  axes.col(1) = normal.cross(axes.col(0));
  return (corners.rowwise() - corners.row(0)) * axes;
}

/// Meisters' ear clipping: an ear is a convex corner whose triangle holds no other corner. After a cut only
/// the two neighbours are looked at again, so the whole takes O(#corners²).
class EarCutter {
 public:
  explicit EarCutter(Points2 points);
  Triangles cut();

 private:
  double turn(int a, int b, int c) const;  // twice the signed area of the triangle
  bool holds(const Triangle& t, int corner) const;
  bool is_ear(int corner) const;

  Points2 points_;
  std::vector<int> previous_, next_;
};

EarCutter::EarCutter(Points2 points) : points_(std::move(points)) {
  const int count = static_cast<int>(points_.rows());
  for (int i = 0; i < count; ++i) {
    previous_.push_back((i + count - 1) % count);
    next_.push_back((i + 1) % count);
  }
}

double EarCutter::turn(int a, int b, int c) const {
  const Eigen::RowVector2d u = points_.row(b) - points_.row(a);
  const Eigen::RowVector2d v = points_.row(c) - points_.row(a);
  return u.x() * v.y() - u.y() * v.x();
}

bool EarCutter::holds(const Triangle& t, int corner) const {
  for (const int own : t) {
    if (points_.row(own) == points_.row(corner)) return false;
  }
  return turn(t[0], t[1], corner) >= 0 && turn(t[1], t[2], corner) >= 0 && turn(t[2], t[0], corner) >= 0;
}

bool EarCutter::is_ear(int corner) const {
  const Triangle t = {previous_[static_cast<std::size_t>(corner)], corner,
                      next_[static_cast<std::size_t>(corner)]};
  if (turn(t[0], t[1], t[2]) <= 0) return false;
  for (int other = next_[static_cast<std::size_t>(t[2])]; other != t[0];
       other = next_[static_cast<std::size_t>(other)]) {
    if (holds(t, other)) return false;
  }
  return true;
}

Triangles EarCutter::cut() {
  std::vector<char> ear(previous_.size());
  for (std::size_t i = 0; i < ear.size(); ++i) ear[i] = is_ear(static_cast<int>(i));
  Triangles triangles;
  int corner = 0;
  for (std::size_t left = ear.size(); left > 2; --left) {
    // A polygon that crosses itself may have no ear left: any corner is then as good.
    for (std::size_t tries = 0; tries < left && !ear[static_cast<std::size_t>(corner)]; ++tries) {
      corner = next_[static_cast<std::size_t>(corner)];
    }
    const int before = previous_[static_cast<std::size_t>(corner)];
    const int after = next_[static_cast<std::size_t>(corner)];
    triangles.push_back({before, corner, after});
    next_[static_cast<std::size_t>(before)] = after;
    previous_[static_cast<std::size_t>(after)] = before;
    for (const int neighbour : {before, after}) ear[static_cast<std::size_t>(neighbour)] = is_ear(neighbour);
    corner = after;
  }
  return triangles;
}

}  // namespace

std::vector<std::array<int, 3>> triangulate(const Positions& corners) {
  const int count = static_cast<int>(corners.rows());
  if (count == 3) return fan(3);
  if (count == 4) return split_quad(corners);
  Triangles simple = fan(count);
  const double share = smallest_share(corners, simple);
  if (count > kMostEars && share < -kSliver) {
    throw InputError(fmt::format(
        "a face of {} corners is not convex; glTF holds triangles, so split it in the mesh", count));
  }
  const bool has_area = area_vector(corners).squaredNorm() > 0;
  if (count > kMostEars || share > kSliver || !has_area) return simple;
  return EarCutter(flatten(corners)).cut();
}

}  // namespace flexkey
