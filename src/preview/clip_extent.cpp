#include "flexkey/preview/clip_extent.h"

#include <algorithm>
#include <set>
#include <utility>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

using Plane = Eigen::Matrix<double, 3, 2>;
using Flat = Eigen::Matrix<double, Eigen::Dynamic, 2>;

/// Twice the area of a, b, c; positive if they turn left.
double turn(const Flat& flat, int a, int b, int c) {
  const Eigen::Vector2d ab = (flat.row(b) - flat.row(a)).transpose();
  const Eigen::Vector2d ac = (flat.row(c) - flat.row(a)).transpose();
  return ab.x() * ac.y() - ab.y() * ac.x();
}

/// The rows that are outermost in eight directions, counter-clockwise, none twice in a row.
std::vector<int> outermost(const Flat& flat) {
  std::vector<int> corners;
  for (const auto& [across, up] :
       {std::pair{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}) {
    Eigen::Index farthest = 0;
    (across * flat.col(0) + up * flat.col(1)).maxCoeff(&farthest);
    if (corners.empty() || corners.back() != farthest) corners.push_back(static_cast<int>(farthest));
  }
  if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  return corners;
}

/// The rows that may be corners of the convex hull: those that are not inside of the outermost ones (Akl and
/// Toussaint, "A fast convex hull algorithm", 1978).
std::vector<int> candidates(const Flat& flat) {
  const std::vector<int> corners = outermost(flat);
  const auto is_inside = [&](int v) {
    for (std::size_t k = 0; k < corners.size(); ++k)
      if (turn(flat, corners[k], corners[(k + 1) % corners.size()], v) <= 0) return false;
    return true;
  };
  std::vector<int> rows;
  for (int v = 0; v < flat.rows(); ++v)
    if (!is_inside(v)) rows.push_back(v);
  return rows;
}

/// One side of the convex hull of `order`, by Andrew's monotone chain; adds its points to `found`.
template <class Order>
void add_chain(const Flat& flat, const Order& order, std::set<int>& found) {
  std::vector<int> chain;
  for (const int v : order) {
    while (chain.size() > 1 && turn(flat, chain[chain.size() - 2], chain.back(), v) <= 0) chain.pop_back();
    chain.push_back(v);
  }
  found.insert(chain.begin(), chain.end());
}

/// Adds the rows that are corners of the convex hull in a plane.
void add_hull(const Positions& points, const Plane& plane, std::set<int>& found) {
  const Flat flat = points * plane;
  std::vector<int> order = candidates(flat);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return flat(a, 0) != flat(b, 0) ? flat(a, 0) < flat(b, 0) : flat(a, 1) < flat(b, 1);
  });
  add_chain(flat, order, found);
  std::reverse(order.begin(), order.end());
  add_chain(flat, order, found);
}

Plane plane_of(const Vec3& a, const Vec3& b) {
  Plane plane;
  plane << a, b;
  return plane;
}

Positions stacked(const Positions& a, const Positions& b) {
  Positions all(a.rows() + b.rows(), 3);
  all << a, b;
  return all;
}

}  // namespace

ClipExtent::ClipExtent(const CameraSettings& settings, const Positions& rest) : rest_(rest) {
  const Camera camera = aimed_camera(settings);
  // What bounds a pyramid of view from the side and from above; and the bounds, and how far a turn reaches.
  planes_ = {plane_of(camera.right, camera.forward), plane_of(camera.up, camera.forward),
             plane_of(Vec3::UnitX(), Vec3::UnitY()), plane_of(Vec3::UnitX(), Vec3::UnitZ())};
}

void ClipExtent::keep_outermost(const Positions& points) {
  if (points.rows() == 0) return;
  std::set<int> found;
  for (const Plane& plane : planes_) add_hull(points, plane, found);
  outline_ = Positions(points(std::vector<int>(found.begin(), found.end()), Eigen::all));
}

void ClipExtent::add(const Positions& frame) {
  if (!frame.allFinite()) throw InputError("a frame has a vertex that is not at a finite place");
  keep_outermost(stacked(outline_, frame));
  if (frame.rows() == rest_.rows() && frame.rows() > 0)
    largest_offset_ = std::max(largest_offset_, (frame - rest_).rowwise().norm().maxCoeff());
}

void ClipExtent::join(const ClipExtent& other) {
  keep_outermost(stacked(outline_, other.outline_));
  largest_offset_ = std::max(largest_offset_, other.largest_offset_);
}

}  // namespace flexkey
