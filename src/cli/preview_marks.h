#pragma once

#include "flexkey/animate/scene.h"
#include "flexkey/preview/renderer.h"

namespace flexkey::cli {

/// What is marked on the surface at a time (seconds): the handles and anchors that hold then, and, where a
/// handle is still under way, the places that it reaches at its next key. posed: #V x 3, the frame.
Marks marks_at(const Scene& scene, double time, const Positions& posed);

}  // namespace flexkey::cli
