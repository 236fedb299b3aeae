#include "flexkey/preview/images/dither.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "flexkey/preview/bayer.h"

namespace flexkey {
namespace {

constexpr int levels = 64;         // of a pattern
constexpr float roughness = 0.1f;  // how much a pattern of two far colours counts against its good mean

float dot(const Srgb& a, const Srgb& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Srgb difference(const Srgb& a, const Srgb& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

std::size_t nearest(const std::vector<Srgb>& colours, const Srgb& target) {
  std::size_t best = 0;
  float least = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const Srgb off = difference(target, colours[i]);
    if (dot(off, off) >= least) continue;
    least = dot(off, off);
    best = i;
  }
  return best;
}

}  // namespace

Dither::Dither(std::vector<Srgb> colours) : colours_(std::move(colours)), mixes_(128 * 128 * 128) {}

Dither::Mix Dither::best_mix(const Srgb& target) const {
  const std::size_t near = nearest(colours_, target);
  const Srgb wanted = difference(target, colours_[near]);
  std::size_t best = near;
  float best_share = 0, least = dot(wanted, wanted);
  for (std::size_t i = 0; i < colours_.size(); ++i) {
    const Srgb step = difference(colours_[i], colours_[near]);
    const float length = dot(step, step);
    if (length == 0) continue;
    const float share = std::clamp(dot(wanted, step) / length, 0.0f, 0.5f);
    const float miss = dot(wanted, wanted) - 2 * share * dot(wanted, step) + share * share * length;
    const float cost = miss + roughness * share * (1 - share) * length;
    if (cost >= least) continue;
    least = cost;
    best = i;
    best_share = share;
  }
  // In one order, whichever is nearer, so that the pattern does not jump where they change places.
  const auto share = static_cast<int>(std::lround(best_share * levels));
  const auto mix = [](std::size_t first, std::size_t second, int of_second) {
    return Mix{static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second),
               static_cast<std::uint8_t>(of_second), true};
  };
  return near <= best ? mix(near, best, share) : mix(best, near, levels - share);
}

std::uint8_t Dither::index(const std::uint8_t* rgb, int x, int y) {
  Mix& mix = mixes_[(rgb[0] / 2u * 128u + rgb[1] / 2u) * 128u + rgb[2] / 2u];
  if (!mix.known) {
    const auto middle = [](std::uint8_t value) { return static_cast<float>(value / 2 * 2) + 0.5f; };
    mix = best_mix({middle(rgb[0]), middle(rgb[1]), middle(rgb[2])});
  }
  return bayer(x, y) < mix.share ? mix.second : mix.first;
}

}  // namespace flexkey
