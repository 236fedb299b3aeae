#pragma once

#include <Eigen/Core>
#include <vector>

#include "flexkey/gltf/motion.h"

namespace flexkey {

/// The keys to keep, increasing, the first and last among them: the others are restored by linear
/// interpolation, with no vertex farther off than `allowed` (file units), and with no more targets active at
/// once than there are now.
/// keys: times, #keys; weights: #keys x #targets; targets: #targets x 3 #vertices.
std::vector<int> kept_keys(const std::vector<double>& keys, const Eigen::MatrixXd& weights,
                           const ShapeRows& targets, double allowed);

}  // namespace flexkey
