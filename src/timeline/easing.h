#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "flexkey/timeline/track.h"

namespace flexkey {

struct NamedEasing {
  std::string_view name;
  Easing easing;
};

/// linear, hold, smooth, and the CSS words ease, ease-in, ease-out and ease-in-out (CSS Easing Functions
/// Level 1).
std::span<const NamedEasing> named_easings();

/// The CSS cubic-bezier curve through (0, 0), (x1, y1), (x2, y2), (1, 1) at abscissa x in [0, 1]: solves
/// 3(1 − u)²u x1 + 3(1 − u)u² x2 + u³ = x for u, within 1e-14, and returns the same polynomial in y.
double cubic_bezier(const Easing& easing, double x);

/// The share of the way at a share s of the stretch, both 0..1 at its ends. `smooth` needs the neighbouring
/// keys and is none of a share's business: see hermite.h.
double eased(const Easing& easing, double s);

}  // namespace flexkey
