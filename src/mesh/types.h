#pragma once

#include <Eigen/Core>

namespace flexkey {

using Vec3 = Eigen::Vector3d;

/// Points or vectors, one a row: #rows x 3, the three coordinates of a row side by side in memory.
using Positions = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Texture coordinates, #rows x 2, v upwards as in OBJ.
using TexCoords = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

}  // namespace flexkey
