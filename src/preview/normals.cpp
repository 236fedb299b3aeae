#include "flexkey/preview/normals.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>

namespace flexkey {
namespace {

constexpr std::size_t kGrain = 4096;

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

Normals::Normals(const Surface& surface)
    : triangles_(surface.triangles),
      offsets_(index(surface.vertex_count) + 1, 0),
      around_(3 * surface.triangles.size()) {
  for (const auto& triangle : triangles_)
    for (const int v : triangle) ++offsets_[index(v) + 1];
  for (std::size_t v = 1; v < offsets_.size(); ++v) offsets_[v] += offsets_[v - 1];
  std::vector<int> next(offsets_.begin(), offsets_.end() - 1);
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (const int v : triangles_[t]) around_[index(next[index(v)]++)] = static_cast<int>(t);
}

Points Normals::at(const Points& points) const {
  Points areas(static_cast<Eigen::Index>(triangles_.size()), 3);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, triangles_.size(), kGrain), [&](const auto& range) {
    for (std::size_t t = range.begin(); t < range.end(); ++t) {
      const auto [a, b, c] = triangles_[t];
      areas.row(static_cast<Eigen::Index>(t)) =
          (points.row(b) - points.row(a)).cross(points.row(c) - points.row(a));
    }
  });
  Points normals(points.rows(), 3);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, offsets_.size() - 1, kGrain), [&](const auto& range) {
    for (std::size_t v = range.begin(); v < range.end(); ++v) {
      Eigen::RowVector3f sum = Eigen::RowVector3f::Zero();
      for (int k = offsets_[v]; k < offsets_[v + 1]; ++k) sum += areas.row(around_[index(k)]);
      normals.row(static_cast<Eigen::Index>(v)) = sum.stableNormalized();
    }
  });
  return normals;
}

}  // namespace flexkey
