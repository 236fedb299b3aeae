#pragma once

#include <vector>

namespace flexkey {

/// A picture in linear light, rows from the top, red green blue interleaved: width * height * 3.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;
};

}  // namespace flexkey
