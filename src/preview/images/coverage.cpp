#include "flexkey/preview/images/coverage.h"

#include <algorithm>

namespace flexkey {

void lay_over(Picture& picture, const Coverage& coverage, int left, int top, const Rgb& colour) {
  const int first_row = std::max(0, -top), end_row = std::min(coverage.height, picture.height - top);
  const int first = std::max(0, -left), end = std::min(coverage.width, picture.width - left);
  for (int y = first_row; y < end_row; ++y) {
    for (int x = first; x < end; ++x) {
      const float share = coverage.share[static_cast<std::size_t>(y * coverage.width + x)];
      float* pixel = &picture.rgb[static_cast<std::size_t>((top + y) * picture.width + left + x) * 3];
      for (int c = 0; c < 3; ++c) pixel[c] += share * (colour[c] - pixel[c]);
    }
  }
}

}  // namespace flexkey
