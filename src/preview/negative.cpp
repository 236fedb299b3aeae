#include "flexkey/preview/negative.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace flexkey {
namespace {

constexpr int kReach = 3;             // pixels
constexpr float kSpread = 3.0f;       // pixels, at one sample; the area falls as noise does
constexpr float kSameNormal = 0.15f;  // difference of normals that still count half or more
constexpr float kSamePlane = 0.004f;  // distance of planes, a share of the diagonal

using Window = std::array<float, 2 * kReach + 1>;

Window gaussian(int samples) {
  const float spread = std::max(kSpread / std::sqrt(std::sqrt(static_cast<float>(samples))), 0.3f);
  Window window;
  for (int k = -kReach; k <= kReach; ++k) {
    const float t = static_cast<float>(k) / spread;
    window[static_cast<std::size_t>(k + kReach)] = std::exp(-0.5f * t * t);
  }
  return window;
}

/// 1 for a neighbour on the same smooth surface, falling to 0.
float kinship(const LitPixel& pixel, const LitPixel& other) {
  const float bend = (pixel.normal - other.normal).squaredNorm() / (kSameNormal * kSameNormal);
  const float step = pixel.normal.dot(other.position - pixel.position) / kSamePlane;
  const float apart = bend + step * step;
  return 1 / (1 + apart * apart);
}

Reached smoothed(const Negative& negative, int x, int y, const Window& window) {
  const LitPixel& pixel = negative.at(x, y);
  Mean key, sky;
  const auto weight = [&](int offset) { return window[static_cast<std::size_t>(offset + kReach)]; };
  for (int dy = std::max(-kReach, -y); dy <= std::min(kReach, negative.height - 1 - y); ++dy) {
    for (int dx = std::max(-kReach, -x); dx <= std::min(kReach, negative.width - 1 - x); ++dx) {
      const LitPixel& other = negative.at(x + dx, y + dy);
      const float share = weight(dx) * weight(dy) * kinship(pixel, other);
      key.sum += share * other.key.sum;
      key.weight += share * other.key.weight;
      sky.sum += share * other.sky.sum;
      sky.weight += share * other.sky.weight;
    }
  }
  return {key.weight > 0 ? key.sum / key.weight : 1, sky.weight > 0 ? sky.sum / sky.weight : 1};
}

}  // namespace

Negative::Negative(int across, int along)
    : width(across),
      height(along),
      pixels(static_cast<std::size_t>(across) * static_cast<std::size_t>(along)) {}

Picture develop(const Negative& negative, int samples) {
  Picture picture{negative.width, negative.height, {}};
  picture.rgb.resize(3 * negative.pixels.size());
  const Window window = gaussian(samples);
  tbb::parallel_for(0, negative.height, [&](int y) {
    float* rgb =
        picture.rgb.data() + 3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(negative.width);
    for (int x = 0; x < negative.width; ++x, rgb += 3) {
      const LitPixel& pixel = negative.at(x, y);
      const bool is_lit = pixel.key.weight > 0 || pixel.sky.weight > 0;
      Eigen::Map<Rgb>{rgb} = pixel.response.under(is_lit ? smoothed(negative, x, y, window) : Reached{});
    }
  });
  return picture;
}

}  // namespace flexkey
