#pragma once

#include <functional>
#include <string>

#include "flexkey/preview/images/colour.h"
#include "flexkey/preview/picture.h"

namespace flexkey {

/// What the colours of a heat map mean.
struct ColourBar {
  std::string title;                       // such as "distance from rest"; may be empty
  double low = 0, high = 1;                // values at the two ends
  std::function<Rgb(float share)> colour;  // of a place on the bar, 0..1
};

/// Draws the bar in the picture's upper right corner with its title above and its two numbers below.
void draw_colour_bar(Picture& picture, const ColourBar& bar);

}  // namespace flexkey
