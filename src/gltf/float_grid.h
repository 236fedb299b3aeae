#pragma once

#include <optional>
#include <span>
#include <vector>

#include "flexkey/gltf/float_rows.h"

namespace flexkey {

/// The nearest multiples of a step, a power of two, which floats hold exactly.
FloatRows on_grid(const FloatRows& rows, double step);

/// The largest power of two that is no larger.
double power_of_two_below(double length);

/// Floats that all are multiples of one power of two, as the filter EXPONENTIAL of EXT_meshopt_compression
/// has them: integers of 24 bits under one exponent of 8, which pack much better. None where there is no such
/// power or the integers do not fit. floats: little-endian, whole floats.
std::optional<std::vector<unsigned char>> grid_integers(std::span<const unsigned char> floats);

}  // namespace flexkey
