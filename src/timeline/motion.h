#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "flexkey/timeline/track.h"

namespace flexkey {

/// Turns about three of the fixed world axes, one after another.
struct EulerTrack {
  std::array<int, 3> order{0, 1, 2};  // of the axes: the first is turned about first
  Track<Vec3> keys;                   // radians about x, y and z
};

/// A motion by its tracks, each empty where it does not move.
struct MotionTracks {
  Track<Vec3> move;
  Track<AxisAngle> rotate;
  Track<Vec3> scale;
};

/// Where a named pose has a handle.
struct PosedHandle {
  Vec3 move{0, 0, 0};
  AxisAngle rotation;
  Vec3 scale{1, 1, 1};
  Mark where;  // of the handle's name in the pose
};
using NamedPose = std::map<std::string, PosedHandle, std::less<>>;

/// The pivot on its way along a curve, by arc length.
struct Follow {
  enum class Orient { none, tangent };
  Curve path;
  Track<double> shares;  // 0..1 of the curve's length
  Orient orient = Orient::none;
};

/// What a periodic or random motion sways: an offset along a direction, or a turn about an axis.
struct Sway {
  enum class Kind { offset, turn };
  Kind kind = Kind::offset;
  Vec3 direction{0, 0, 1};  // unit
  Length amplitude;         // of an offset: mesh units or a share of the diagonal; of a turn: radians
};

/// amplitude · sin(2π frequency t + phase).
struct Wave {
  Sway sway;
  double frequency = 1;  // hertz
  double phase = 0;      // radians
};

/// amplitude · smooth noise of t in −1..1 with about `frequency` swings a second.
struct Noise {
  Sway sway;
  double frequency = 1;
  std::uint32_t seed = 0;
  double delay = 0;  // seconds
};

/// Another handle's motion as in a mirror.
struct Mirror {
  int of = -1;           // a handle of the shot
  Vec3 normal{1, 0, 0};  // of the mirror, unit
  double delay = 0;      // seconds
};

}  // namespace flexkey
