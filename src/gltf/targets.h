#pragma once

#include <vector>

#include "flexkey/gltf/float_rows.h"

namespace flexkey {

/// Morph targets as they are written, deltas from the base of which each vertex of the mesh has a row.
struct MorphTargets {
  std::vector<FloatRows> positions;  // #targets of #V x 3
  std::vector<FloatRows> normals;    // the same; none without normals
};

}  // namespace flexkey
