#include "flexkey/gltf/float_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace flexkey {
namespace {

constexpr int kMantissaBits = 23, kBias = 127;
constexpr int kFarthestExponent = 100;  // the filter's own limit

/// The exponent of a finite float's lowest bit that is set; none for zero.
std::optional<int> lowest_exponent(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t fraction = bits & ((1U << kMantissaBits) - 1);
  const int exponent = static_cast<int>(bits >> kMantissaBits & 0xFF);
  if (exponent == 0 && fraction == 0) return std::nullopt;
  const std::uint32_t mantissa = exponent == 0 ? fraction : fraction | 1U << kMantissaBits;
  return std::max(exponent, 1) - kBias - kMantissaBits + std::countr_zero(mantissa);
}

}  // namespace

FloatRows on_grid(const FloatRows& rows, double step) {
  return ((rows.cast<double>() / step).array().round() * step).cast<float>();
}

double power_of_two_below(double length) {
  return std::exp2(std::floor(std::log2(length)));
}

std::optional<std::vector<unsigned char>> grid_integers(std::span<const unsigned char> floats) {
  std::vector<float> values(floats.size() / sizeof(float));
  std::memcpy(values.data(), floats.data(), floats.size());
  int exponent = std::numeric_limits<int>::max();
  for (const float value : values) {
    if (!std::isfinite(value)) return std::nullopt;
    if (const std::optional<int> lowest = lowest_exponent(value)) exponent = std::min(exponent, *lowest);
  }
  if (exponent == std::numeric_limits<int>::max()) exponent = 0;  // zeros alone
  if (std::abs(exponent) > kFarthestExponent) return std::nullopt;
  std::vector<unsigned char> words(floats.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double integer = std::ldexp(static_cast<double>(values[i]), -exponent);
    if (std::abs(integer) >= 1 << kMantissaBits) return std::nullopt;
    const std::uint32_t word = static_cast<std::uint32_t>(exponent) << 24 |
                               (static_cast<std::uint32_t>(static_cast<std::int32_t>(integer)) & 0xFFFFFFU);
    std::memcpy(words.data() + i * sizeof(word), &word, sizeof(word));
  }
  return words;
}

}  // namespace flexkey
