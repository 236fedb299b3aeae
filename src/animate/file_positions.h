#pragma once

#include "flexkey/animate/scene.h"

namespace flexkey {

/// The pose's positions with what rides on it, given back to the file's vertices, #V x 3.
Positions file_positions(const Scene& scene, const Pose& pose);

}  // namespace flexkey
