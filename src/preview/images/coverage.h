#pragma once

#include <vector>

#include "flexkey/preview/colour.h"
#include "flexkey/preview/picture.h"

namespace flexkey {

/// How much of each pixel a shape covers, 0..1: width * height, rows from the top.
struct Coverage {
  int width = 0, height = 0;
  int left = 0, top = 0;  // of its first pixel in the shape's own coordinates; for text, from the start of
                          // its baseline
  std::vector<float> share;
};

/// Lays a colour over the picture through the coverage, its first pixel at (left, top). What lies outside is
/// cut.
void lay_over(Picture& picture, const Coverage& coverage, int left, int top, const Rgb& colour);

}  // namespace flexkey
