#include "flexkey/preview/images/srgb.h"

#include <algorithm>
#include <cmath>

namespace flexkey {

float srgb_from_linear(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

float linear_from_srgb(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

std::vector<std::uint8_t> srgb_bytes(const Picture& picture) {
  std::vector<std::uint8_t> bytes(picture.rgb.size());
  std::transform(picture.rgb.begin(), picture.rgb.end(), bytes.begin(), [](float linear) {
    if (!(linear > 0)) return std::uint8_t{0};  // NaN too
    return static_cast<std::uint8_t>(std::lround(255 * srgb_from_linear(std::min(linear, 1.0f))));
  });
  return bytes;
}

}  // namespace flexkey
