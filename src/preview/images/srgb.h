#pragma once

#include <cstdint>
#include <vector>

#include "flexkey/preview/picture.h"

namespace flexkey {

/// The sRGB transfer curve and its inverse (IEC 61966-2-1), 0..1 to 0..1.
float srgb_from_linear(float linear);
float linear_from_srgb(float encoded);

/// The nearest 8-bit sRGB values, width * height * 3. What is beyond 0..1 is clamped; NaN is black.
std::vector<std::uint8_t> srgb_bytes(const Picture& picture);

}  // namespace flexkey
