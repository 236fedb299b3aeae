#include "flexkey/preview/light.h"

#include <gtest/gtest.h>

#include "flexkey/preview/images/srgb.h"

namespace flexkey {
namespace {

TEST(Backdrop, EightBitsFollowItWithoutBands) {
  const View view(Camera(), UnitSpace({}), 640, 360);
  for (int top = 0; top < 360; top += 8) {
    for (int left = 0; left < 640; left += 8) {
      double wanted = 0, stored = 0;  // green, of a block that has each place of the pattern once
      for (int k = 0; k < 64; ++k) {
        const Rgb colour = backdrop(view, left + k % 8, top + k / 8);
        const Picture pixel{1, 1, {colour[0], colour[1], colour[2]}};
        wanted += 255 * srgb_from_linear(colour[1]);
        stored += srgb_bytes(pixel)[1];
      }
      EXPECT_NEAR(stored / 64, wanted / 64, 0.1) << left << " " << top;
    }
  }
}

}  // namespace
}  // namespace flexkey
