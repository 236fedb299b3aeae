#pragma once

#include <string>
#include <vector>

#include "flexkey/preview/images/draw.h"

namespace flexkey {

/// A name for a place in a picture.
struct Label {
  std::string text;
  Point at;
  Rgb colour;
};

/// Writes the labels at the picture's left and right edges, each on the side of its place and joined to it by
/// a line: no two lie on each other, and smaller the more there are.
void draw_labels(Picture& picture, const std::vector<Label>& labels);

}  // namespace flexkey
