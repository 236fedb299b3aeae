#pragma once

#include "flexkey/preview/subdivision.h"

namespace flexkey {

/// The subdivided points of a mesh at the places of `positions`.
inline Points refined_points(const Subdivision& subdivision, const Positions& positions) {
  return subdivision.points(positions(subdivision.control_vertices(), Eigen::all).cast<float>());
}

}  // namespace flexkey
