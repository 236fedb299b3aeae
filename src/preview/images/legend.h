#pragma once

#include <string>
#include <vector>

#include "flexkey/preview/images/colour.h"
#include "flexkey/preview/picture.h"

namespace flexkey {

/// What the colours of a heat map mean.
struct Legend {
  std::string title;            // such as "displacement"
  std::vector<Colour> colours;  // from low to high, evenly spaced; at least one
  double low = 0, high = 1;
};

/// Draws the legend in the picture's upper right corner: a bar of the colours with its two numbers below.
void draw_legend(Picture& picture, const Legend& legend);

}  // namespace flexkey
