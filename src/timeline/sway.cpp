#include "flexkey/timeline/sway.h"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace flexkey {
namespace {

/// A number in −1..1 for each place of each seed: Steele, Lea and Flood's SplitMix64, 2014.
double gradient(std::uint32_t seed, std::int64_t place) {
  std::uint64_t bits = (std::uint64_t{seed} << 32) ^ static_cast<std::uint64_t>(place) * 0x9e3779b97f4a7c15U;
  bits += 0x9e3779b97f4a7c15U;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
  bits ^= bits >> 31;
  return std::ldexp(static_cast<double>(bits >> 11), -52) - 1;
}

}  // namespace

double wave_at(const Wave& wave, double time) {
  return std::sin(2 * std::numbers::pi * wave.frequency * time + wave.phase);
}

double noise_at(const Noise& noise, double time) {
  const double at = (time - noise.delay) * noise.frequency, place = std::floor(at), s = at - place;
  const auto k = static_cast<std::int64_t>(place);
  const double fade = s * s * s * (s * (6 * s - 15) + 10);
  const double before = gradient(noise.seed, k) * s, after = gradient(noise.seed, k + 1) * (s - 1);
  return 2 * (before + fade * (after - before));  // two gradients of 1 meet at 1/2
}

}  // namespace flexkey
