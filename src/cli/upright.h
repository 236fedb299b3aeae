#pragma once

#include "flexkey/animate/clip.h"
#include "flexkey/gltf/write_glb.h"
#include "flexkey/timeline/shot.h"

namespace flexkey::cli {

// A mesh whose upward axis is z stands upright in glTF, whose is y: (x, y, z) becomes (x, z, -y).

Positions upright(const Positions& points);

/// With the handles and poses that are written beside it; nothing changes where up is y.
void stand_upright(UpAxis up, Clip& clip, GltfOptions& options);

}  // namespace flexkey::cli
