#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "flexkey/preview/render_options.h"

namespace flexkey {

/// What a picture's colours mean, for a scale drawn beside it.
struct Legend {
  std::string title;                       // "distance from rest, % of the diagonal"
  double low = 0, high = 1;                // values at the two ends of the scale
  std::function<Rgb(float share)> colour;  // of a place on the scale, 0..1
};

/// None for styles whose colours are no measure.
std::optional<Legend> legend_of(const RenderOptions& options);

/// The largest distance of a vertex from rest over all frames, as a share of the rest diagonal, rounded up to
/// 1, 2 or 5 times a power of ten: the top of a scale that serves the whole clip. At least 0.1%.
double displacement_top(const Positions& rest, std::span<const Positions> frames);

}  // namespace flexkey
