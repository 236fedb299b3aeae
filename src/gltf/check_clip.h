#pragma once

#include "flexkey/animate/clip.h"

namespace flexkey {

/// Throws InputError for a clip that glTF cannot hold as morph targets: no frames, coordinates that are no
/// finite 32-bit floats, a frame rate out of 0.001 .. 1,000,000, or parts that do not fit each other.
void check_clip(const Clip& clip);

}  // namespace flexkey
