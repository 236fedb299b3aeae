#pragma once

#include <Eigen/Core>
#include <vector>

#include "flexkey/animate/scene.h"

namespace flexkey {

/// Each handle's motion from rest to a time (seconds) as the timeline has it, whether it holds then or not:
/// #handles, a point x at rest goes to M [x 1]ᵀ. Of a `curve` handle the rigid motion that fits its vertices
/// best.
std::vector<Eigen::Matrix4d> handle_matrices(const Scene& scene, double time);

}  // namespace flexkey
