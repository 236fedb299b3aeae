#pragma once

#include <functional>
#include <vector>

#include "flexkey/animate/clip.h"
#include "flexkey/animate/scene.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// What a caller may hear of a running solve.
struct AnimateHooks {
  std::function<void(const FrameReport&)> on_frame = {};  // after each solved frame
  std::function<bool()> stop = {};                        // true ends the solve after the current frame
};

/// Solves the shot from frame 0, each frame starting from the one before, and keeps the frames of `wanted`
/// (increasing; all frames where it is empty). The clip ends early where `stop` said so.
/// Throws DeformError if the surface cannot be solved.
Clip animate(const Shot& shot, const Mesh& mesh, const Scene& scene, const std::vector<int>& wanted = {},
             const AnimateHooks& hooks = {});

/// The same for the one-off case: binds the shot and solves all of it.
Clip animate(const Shot& shot, const Mesh& mesh);

/// Where the vertices of Scene::constraints.handles go at a time, #handles x 3.
Positions sample_targets(const Scene& scene, double time);

}  // namespace flexkey
