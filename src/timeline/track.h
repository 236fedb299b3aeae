#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flexkey/mesh/selection.h"
#include "flexkey/mesh/types.h"

namespace flexkey {

/// How a stretch goes from its key to the next.
struct Easing {
  enum class Kind { linear, hold, bezier, smooth };
  Kind kind = Kind::linear;
  double x1 = 0, y1 = 0, x2 = 1, y2 = 1;  // bezier: CSS cubic-bezier control points, x in [0, 1]
};

template <class Value>
struct Key {
  double time = 0;  // seconds
  Value value{};
  Easing ease;  // of the stretch after the key
};

/// Keys in increasing time; empty means that the timeline says nothing of this motion.
template <class Value>
using Track = std::vector<Key<Value>>;

/// A turn by `angle` radians about a unit axis; the angle itself is interpolated, so 4π is two turns.
struct AxisAngle {
  Vec3 axis{0, 0, 1};
  double angle = 0;
};

/// A curve in space: what a `path` selection's vertices are laid on.
struct Curve {
  enum class Kind { rest, polyline, catmull_rom, bezier };
  Kind kind = Kind::rest;
  std::vector<Vec3> points;  // control points; bezier: 3n + 1 of them; rest: none
};

}  // namespace flexkey
