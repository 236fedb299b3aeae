#pragma once

#include <Eigen/Core>
#include <filesystem>

#include "flexkey/animate/clip.h"

namespace flexkey {

/// Points in single precision, #V x 3.
using FloatPositions = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// The frame's positions in single precision. Throws OutputError, which names `path` and the vertex, for
/// what is not a finite float.
FloatPositions float_positions(const SolvedFrame& frame, const std::filesystem::path& path);

/// Throws OutputError, which names `path` and the vertex, for a position that is not finite.
void require_finite(const SolvedFrame& frame, const std::filesystem::path& path);

}  // namespace flexkey
