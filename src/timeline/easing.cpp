#include "flexkey/timeline/easing.h"

#include <array>
#include <cmath>

namespace flexkey {
namespace {

constexpr Easing bezier(double x1, double y1, double x2, double y2) {
  return {Easing::Kind::bezier, x1, y1, x2, y2};
}

constexpr std::array<NamedEasing, 7> easings = {{
    {"linear", {}},
    {"hold", {.kind = Easing::Kind::hold}},
    {"ease", bezier(0.25, 0.1, 0.25, 1)},
    {"ease-in", bezier(0.42, 0, 1, 1)},
    {"ease-out", bezier(0, 0, 0.58, 1)},
    {"ease-in-out", bezier(0.42, 0, 0.58, 1)},
    {"smooth", {.kind = Easing::Kind::smooth}},
}};

/// One coordinate of the curve with control values 0, a, b, 1.
double coordinate(double a, double b, double u) {
  const double v = 1 - u;
  return 3 * v * v * u * a + 3 * v * u * u * b + u * u * u;
}

}  // namespace

std::span<const NamedEasing> named_easings() {
  return easings;
}

double cubic_bezier(const Easing& easing, double x) {
  if (x <= 0) return 0;
  if (x >= 1) return 1;
  // x(u) rises monotonically for x1, x2 in [0, 1]; halving needs no slope, which may vanish at the ends and
  // inside.
  double low = 0, high = 1;
  for (int step = 0; step < 60 && high - low > 0; ++step) {
    const double middle = 0.5 * (low + high);
    (coordinate(easing.x1, easing.x2, middle) < x ? low : high) = middle;
  }
  return coordinate(easing.y1, easing.y2, 0.5 * (low + high));
}

double eased(const Easing& easing, double s) {
  switch (easing.kind) {
    case Easing::Kind::hold:
      return s < 1 ? 0 : 1;
    case Easing::Kind::bezier:
      return cubic_bezier(easing, s);
    case Easing::Kind::linear:
    case Easing::Kind::smooth:
      break;
  }
  return s;
}

}  // namespace flexkey
