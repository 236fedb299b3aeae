#pragma once

#include <vector>

#include "flexkey/gltf/quantize.h"
#include "flexkey/gltf/targets.h"

namespace flexkey {

/// Which vertices any target moves or turns, #V.
std::vector<bool> moved_vertices(const MorphTargets& targets);
std::vector<bool> moved_vertices(const QuantizedTargets& targets);

}  // namespace flexkey
