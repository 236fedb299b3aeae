#pragma once

#include "flexkey/preview/final_pass.h"

namespace flexkey {

/// The picture by z-buffer: one sample a pixel, a hard shadow on the ground, none on the surface.
Picture draft_picture(const Studio& studio);

}  // namespace flexkey
