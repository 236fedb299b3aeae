#include "flexkey/preview/colour.h"

#include <algorithm>
#include <array>
#include <span>

#include "flexkey/preview/images/srgb.h"

namespace flexkey {
namespace {

/// sRGB, 0..255.
using Stop = std::array<float, 3>;

/// Stops at equal distances, blended as the file formats hold them, so that steps look even.
Rgb blend(std::span<const Stop> stops, float share) {
  const float place = std::clamp(share, 0.0f, 1.0f) * static_cast<float>(stops.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const float part = place - static_cast<float>(k);
  const Eigen::Map<const Rgb> a(stops[k].data()), b(stops[k + 1].data());
  return from_srgb(((1 - part) * a + part * b) / 255);
}

}  // namespace

Rgb from_srgb(const Rgb& srgb) {
  return srgb.unaryExpr([](float encoded) { return linear_from_srgb(encoded); });
}

Rgb colour_from_srgb(int red, int green, int blue) {
  return from_srgb(Eigen::Vector3i(red, green, blue).cast<float>() / 255);
}

Rgb viridis(float share) {
  static constexpr std::array<Stop, 9> stops{{{68, 1, 84},
                                              {71, 44, 122},
                                              {59, 81, 139},
                                              {44, 113, 142},
                                              {33, 144, 141},
                                              {39, 173, 129},
                                              {92, 200, 99},
                                              {170, 220, 50},
                                              {253, 231, 37}}};
  return blend(stops, share);
}

Rgb lambda_colour(float lambda) {
  static constexpr std::array<Stop, 3> stops{{{86, 141, 170}, {214, 201, 184}, {190, 96, 66}}};
  return blend(stops, lambda);
}

}  // namespace flexkey
