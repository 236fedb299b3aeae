#pragma once

#include <vector>

#include "flexkey/animate/clip.h"
#include "flexkey/gltf/write_glb.h"

namespace flexkey {

/// Throws InputError for a clip that glTF cannot hold as morph targets: no frames, coordinates that are no
/// finite 32-bit floats, a frame rate out of 0.001 .. 1,000,000, or parts that do not fit each other.
void check_clip(const Clip& clip);

/// The same for poses of its mesh.
void check_poses(const Clip& clip, const std::vector<PoseShape>& poses);

}  // namespace flexkey
