#pragma once

#include "flexkey/animate/scene.h"
#include "flexkey/mesh/select.h"

namespace flexkey {

/// The shot's regions of λ as shares of the surface: 1 in a region, and smoothstep(1 − d / feather) at the
/// distance d from it along the surface. Throws SelectionError.
std::vector<LambdaPaint> paint_regions(const Shot& shot, const Mesh& surface, const Selector& selector);

/// λ of every vertex of the surface at a time, #V: the shot's, and over it each region's by its share, the
/// later over the earlier.
Eigen::VectorXd lambda_at(const Shot& shot, const Scene& scene, double time);

}  // namespace flexkey
