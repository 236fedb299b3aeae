#include "flexkey/gltf/moved_vertices.h"

#include <cstddef>

namespace flexkey {
namespace {

/// Marks the rows that are not zero in one of the lists.
template <class... Lists>
std::vector<bool> rows_of_any(Eigen::Index count, const Lists&... lists) {
  std::vector<bool> marked(static_cast<std::size_t>(count), false);
  const auto mark = [&](const auto& rows) {
    for (Eigen::Index row = 0; row < rows.rows(); ++row)
      if ((rows.row(row).array() != 0).any()) marked[static_cast<std::size_t>(row)] = true;
  };
  const auto mark_all = [&](const auto& list) {
    for (const auto& rows : list) mark(rows);
  };
  (mark_all(lists), ...);
  return marked;
}

}  // namespace

std::vector<bool> moved_vertices(const MorphTargets& targets) {
  return rows_of_any(targets.positions.front().rows(), targets.positions, targets.normals);
}

std::vector<bool> moved_vertices(const QuantizedTargets& targets) {
  return rows_of_any(targets.positions.front().rows(), targets.positions, targets.normals,
                     targets.float_normals, targets.poses.positions, targets.poses.normals);
}

}  // namespace flexkey
