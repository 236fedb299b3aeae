#pragma once

#include "cli/load.h"
#include "flexkey/gltf/write_glb.h"

namespace flexkey::cli {

/// What the shot asks of its GLB, in the writer's terms.
GltfOptions gltf_options(const Shot& run, const LoadedShot& loaded);

/// The scene's handles, with no frames yet.
std::vector<HandleTrack> handle_tracks(const Scene& scene);

}  // namespace flexkey::cli
