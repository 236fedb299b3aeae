#pragma once

#include <Eigen/Core>

namespace flexkey {

/// Red, green and blue in linear light, 0..1.
using Rgb = Eigen::Vector3f;

}  // namespace flexkey
