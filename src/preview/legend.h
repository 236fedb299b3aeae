#pragma once

#include <functional>
#include <optional>
#include <string>

#include "flexkey/preview/render_options.h"

namespace flexkey {

/// What a picture's colours mean, for a scale drawn into it (images/draw_legend.h).
struct Legend {
  std::string title;                       // "distance from rest, % of the diagonal"; may be empty
  double low = 0, high = 1;                // values at the two ends of the scale
  std::function<Rgb(float share)> colour;  // of a place on the scale, 0..1
};

/// None for styles whose colours are no measure.
std::optional<Legend> legend_of(const RenderOptions& options);

/// The top of a scale that serves a whole clip: the largest distance of a vertex from rest (mesh units) as a
/// share of the rest diagonal, rounded up to 1, 2 or 5 times a power of ten; at least 0.1%.
double displacement_top(double largest_offset, double diagonal);

}  // namespace flexkey
