#pragma once

#include <Eigen/Core>
#include <vector>

#include "flexkey/animate/clip.h"
#include "flexkey/gltf/graft.h"
#include "flexkey/gltf/write_glb.h"

namespace flexkey {

/// Frames that an animation of a file plays.
struct PlayedRange {
  int animation = 0;        // index in the file
  double from = 0, to = 0;  // seconds of the shot, both included
};

/// A node a handle for this file: at rest at the handle's pivot, and led by channels of each animation as the
/// handle was, a key a frame. Handles that neither turn, nor move, nor grow have no channels. A name that a
/// node has already gets a number behind it.
Addition add_handles(const Glb& file, const Clip& clip, const std::vector<HandleTrack>& handles,
                     const std::vector<PlayedRange>& ranges);

}  // namespace flexkey
