#include "flexkey/preview/render_options.h"

#include <fmt/format.h>

#include <cmath>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

constexpr int kLongestSide = 16'384;      // what image formats and viewers take
constexpr long kMostPixels = 36'000'000;  // 3 GB while a picture is made; 7680 x 4320 fits
constexpr int kMostSamples = 4096;

void require(bool holds, const std::string& problem) {
  if (!holds) throw InputError(problem);
}

}  // namespace

void check_options(const RenderOptions& options) {
  const int width = options.width, height = options.height;
  require(width >= 1 && height >= 1, fmt::format("a picture of {} x {} pixels has no pixel", width, height));
  require(width <= kLongestSide && height <= kLongestSide && static_cast<long>(width) * height <= kMostPixels,
          fmt::format("a picture of {} x {} pixels is too large: at most {} a side and {} million in all",
                      width, height, kLongestSide, kMostPixels / 1'000'000));
  require(options.samples >= 1 && options.samples <= kMostSamples,
          fmt::format("{} samples a pixel are outside 1..{}", options.samples, kMostSamples));
  require(!options.floor || std::isfinite(*options.floor), "the ground is not at a finite height");
  require(std::isfinite(options.displacement_top) && options.displacement_top >= 0,
          fmt::format("the displacement of the last colour, {:g}, is not a share of the diagonal",
                      options.displacement_top));
}

}  // namespace flexkey
