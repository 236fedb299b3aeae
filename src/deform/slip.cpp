#include "flexkey/deform/slip.h"

#include <numbers>

namespace flexkey {
namespace {

// Neighbours that kept together differ by less than half a turn, those that slipped by nearly one.
constexpr double apart = 1.25 * std::numbers::pi;

bool handles_are_wound(const Positions& winding) {
  for (Eigen::Index a = 0; a < winding.rows(); ++a)
    for (Eigen::Index b = 0; b < a; ++b)
      if ((winding.row(a) - winding.row(b)).norm() >= std::numbers::pi) return true;
  return false;
}

}  // namespace

bool has_slipped(const Cells& cells, const Course& course) {
  if (!handles_are_wound(course.handle_winding)) return false;
  const auto count = static_cast<int>(course.winding.rows());
  for (int i = 0; i < count; ++i)
    for (const auto [j, weight] : cells.of(i))
      if (j < i && (course.winding.row(i) - course.winding.row(j)).norm() > apart) return true;
  return false;
}

}  // namespace flexkey
