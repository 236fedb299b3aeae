#pragma once

#include <vector>

#include "flexkey/preview/drawn_frame.h"

namespace flexkey {

/// What is nearest at the middle of each pixel.
struct Fragment {
  Hit::What what = Hit::What::nothing;
  int index = -1;   // triangle, wire or dot
  float depth = 0;  // along the camera's forward axis
};

/// Rows from the top, width * height. Triangles with a corner behind the camera are left out.
std::vector<Fragment> rasterize(const DrawnFrame& frame, const View& view);

/// The pixels at which the ground lies in the hard shadow that the points throw along `key`.
std::vector<char> rasterize_shadow(const DrawnFrame& frame, const View& view, const Light& light);

}  // namespace flexkey
