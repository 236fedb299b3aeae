#include "flexkey/preview/sampling.h"

#include <cmath>
#include <numbers>

namespace flexkey {
namespace {

/// Wellons's lowbias32: every input bit moves every output bit half of the time.
std::uint32_t hash(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  x ^= x >> 16;
  return x;
}

std::uint32_t reversed_bits(std::uint32_t x) {
  x = (x << 16) | (x >> 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
  x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
  x = ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
  return x;
}

/// 32 bits as a number in [0, 1).
float fraction(std::uint32_t x) {
  return static_cast<float>(x >> 8) * 0x1p-24f;
}

/// Jimenez's interleaved gradient noise (SIGGRAPH 2014): the values of any 3 x 3 pixels lie about evenly in
/// [0, 1), so that an average over neighbours has little noise left. Uses are patterns far apart in one
/// plane.
float interleaved(const PixelSample& sample, std::uint32_t use) {
  const double apart = 5.588238 * use;
  const double inner = 0.06711056 * (sample.x + apart) + 0.00583715 * (sample.y + apart);
  const double outer = 52.9829189 * (inner - std::floor(inner));
  return static_cast<float>(outer - std::floor(outer));
}

float wrapped(float x) {
  return x < 1 ? x : x - 1;
}

}  // namespace

Eigen::Vector2f PixelSample::at(Purpose purpose) const {
  const auto use = static_cast<std::uint32_t>(purpose), n = static_cast<std::uint32_t>(count);
  const std::uint32_t start = hash(x + hash(y + hash(use)));
  const std::uint32_t k = (static_cast<std::uint32_t>(index) + start % n) % n;
  const float even = (static_cast<float>(k) + interleaved(*this, 2 * use)) / static_cast<float>(n);
  return {wrapped(even), wrapped(fraction(reversed_bits(k)) + interleaved(*this, 2 * use + 1))};
}

Eigen::Vector2f on_disc(const Eigen::Vector2f& square) {
  const Eigen::Vector2f p = 2 * square - Eigen::Vector2f(1, 1);
  if (p.x() == 0 && p.y() == 0) return {0, 0};
  constexpr float quarter = std::numbers::pi_v<float> / 4;
  const bool is_wide = std::abs(p.x()) > std::abs(p.y());
  const float radius = is_wide ? p.x() : p.y();
  const float angle = is_wide ? quarter * p.y() / p.x() : 2 * quarter - quarter * p.x() / p.y();
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace flexkey
