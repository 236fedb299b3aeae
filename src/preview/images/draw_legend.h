#pragma once

#include "flexkey/preview/legend.h"
#include "flexkey/preview/picture.h"

namespace flexkey {

/// Draws the scale in the picture's upper right corner with its title above and its two numbers below.
void draw_legend(Picture& picture, const Legend& legend);

}  // namespace flexkey
