#include "flexkey/preview/legend.h"

#include <algorithm>
#include <cmath>

namespace flexkey {
namespace {

double rounded_up(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0})
    if (value <= step * power * (1 + 1e-9)) return step * power;
  return 10 * power;
}

}  // namespace

std::optional<Legend> legend_of(const RenderOptions& options) {
  if (options.style == Style::displacement)
    return Legend{"distance from rest, % of the diagonal", 0, 100 * options.displacement_top, viridis};
  if (options.style == Style::lambda) return Legend{"λ: 0 smooth, 1 rigid", 0, 1, lambda_colour};
  return std::nullopt;
}

double displacement_top(double largest_offset, double diagonal) {
  constexpr double least = 1e-3;
  return rounded_up(std::max(diagonal > 0 ? largest_offset / diagonal : 0.0, least));
}

}  // namespace flexkey
