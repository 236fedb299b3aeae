#pragma once

#include <vector>

#include "flexkey/mesh/connectivity.h"

namespace flexkey {

/// The components that remain when each group of vertices joins all that it touches, numbered in the order of
/// the first of what they were. Vertices of no component stay so.
Components join_components(const Components& components, const std::vector<std::vector<int>>& groups);

}  // namespace flexkey
