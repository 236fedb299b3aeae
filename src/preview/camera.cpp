#include "flexkey/preview/camera.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kDegree = std::numbers::pi / 180;

void require(bool holds, const std::string& problem) {
  if (!holds) throw InputError(problem);
}

void check(const CameraSettings& settings) {
  const double elevation = settings.elevation / kDegree, fov = settings.fov / kDegree;
  require(std::isfinite(settings.azimuth), "the camera's azimuth is not a finite number");
  require(std::abs(elevation) <= 90 + 1e-9,
          fmt::format("a camera elevation of {:g} degrees is outside -90..90", elevation));
  require(fov >= 0.1 && fov <= 170, fmt::format("a camera fov of {:g} degrees is outside 0.1..170", fov));
  require(settings.zoom >= 1e-3 && settings.zoom <= 1e3,
          fmt::format("a camera zoom of {:g} is outside 0.001..1000", settings.zoom));
  require(settings.margin >= 0 && settings.margin < 0.5,
          fmt::format("a margin of {:g} of the picture is outside 0..0.5", settings.margin));
  require(settings.footer >= 0 && settings.footer + 2 * settings.margin < 1,
          fmt::format("a footer of {:g} of the picture leaves no room", settings.footer));
  require(!settings.look_at || settings.look_at->allFinite(), "the camera looks at no finite point");
}

/// Angles from the middle of the picture to the sides of what must hold the points, as tangents.
struct Opening {
  double across = 0, top = 0, bottom = 0;

  Opening(const CameraSettings& settings, double aspect) {
    const double half = std::tan(settings.fov / 2);
    top = half * (1 - 2 * settings.margin);
    bottom = top - 2 * half * settings.footer;
    across = top * aspect;
  }
};

/// How far points reach past the four side planes of the pyramid of view whose tip is the origin.
struct Reach {
  double right = -kInfinity, left = -kInfinity, top = -kInfinity, bottom = -kInfinity;

  void add(const Camera& camera, const Opening& opening, const Vec3& p) {
    const double x = p.dot(camera.right), y = p.dot(camera.up), z = p.dot(camera.forward);
    right = std::max(right, x - opening.across * z);
    left = std::max(left, -x - opening.across * z);
    top = std::max(top, y - opening.top * z);
    bottom = std::max(bottom, -y - opening.bottom * z);
  }
};

/// The nearest place from which everything is seen, with the same room on opposite sides.
Vec3 centred_place(const Camera& camera, const Opening& opening, const Reach& reach) {
  const double z = -std::max((reach.right + reach.left) / (2 * opening.across),
                             (reach.top + reach.bottom) / (opening.top + opening.bottom));
  const double x = (reach.right - reach.left) / 2;
  const double y = (reach.top - reach.bottom + (opening.top - opening.bottom) * z) / 2;
  return x * camera.right + y * camera.up + z * camera.forward;
}

/// Extremes of what is seen along one axis of the picture: slope and depth of the outermost points.
struct Extremes {
  double low = kInfinity, low_depth = 0, high = -kInfinity, high_depth = 0;

  void add(double offset, double depth) {
    const double slope = offset / depth;
    if (slope < low) low = slope, low_depth = depth;
    if (slope > high) high = slope, high_depth = depth;
  }
  /// The step that puts `middle` (a slope) halfway between them, if these points stay the outermost.
  double step_to(double middle) const {
    return low_depth * high_depth * (low + high - 2 * middle) / (low_depth + high_depth);
  }
};

/// Where a camera that is farther off than its other direction asks for has the same room on both sides.
Vec3 evened_place(const Camera& camera, const Opening& opening, Vec3 place,
                  std::span<const Positions> frames) {
  constexpr int steps = 3;  // the outermost points rarely change after the first
  const double middle = (opening.top - opening.bottom) / 2;
  for (int k = 0; k < steps; ++k) {
    Extremes across, along;
    for (const Positions& frame : frames) {
      for (Eigen::Index v = 0; v < frame.rows(); ++v) {
        const Vec3 p = frame.row(v).transpose() - place;
        const double depth = p.dot(camera.forward);
        if (depth <= 0) return place;  // a point that touches the camera
        across.add(p.dot(camera.right), depth);
        along.add(p.dot(camera.up), depth);
      }
    }
    place += across.step_to(0) * camera.right + along.step_to(middle) * camera.up;
  }
  return place;
}

/// The nearest place on the line through `centre` from which everything is seen. The reach is that of points
/// relative to the centre: one step back along the line takes the opening off it.
Vec3 place_behind(const Camera& camera, const Opening& opening, const Reach& reach) {
  const double back = std::max({std::max(reach.right, reach.left) / opening.across, reach.top / opening.top,
                                reach.bottom / opening.bottom, 0.0});
  return camera.centre - back * camera.forward;
}

/// The circles that the bounds' outermost points run through on a turntable, as points.
Positions swept(std::span<const Positions> frames, const Vec3& centre, const Vec3& up) {
  double radius = 0, low = 0, high = 0;
  for (const Positions& frame : frames) {
    for (Eigen::Index v = 0; v < frame.rows(); ++v) {
      const Vec3 p = frame.row(v).transpose() - centre;
      const double height = p.dot(up);
      radius = std::max(radius, (p - height * up).norm());
      low = std::min(low, height);
      high = std::max(high, height);
    }
  }
  constexpr int steps = 64;
  const Vec3 side = up.unitOrthogonal(), front = up.cross(side);
  Positions points(2 * steps, 3);
  for (int k = 0; k < steps; ++k) {
    const double angle = 2 * std::numbers::pi * k / steps;
    const Vec3 level = centre + radius * (std::cos(angle) * side + std::sin(angle) * front);
    points.row(2 * k) = (level + low * up).transpose();
    points.row(2 * k + 1) = (level + high * up).transpose();
  }
  return points;
}

Reach reach_of(std::span<const Positions> frames, const Camera& camera, const Opening& opening) {
  Reach reach;
  for (const Positions& frame : frames)
    for (Eigen::Index v = 0; v < frame.rows(); ++v)
      reach.add(camera, opening, Vec3(frame.row(v).transpose() - camera.centre));
  return reach;
}

}  // namespace

Vec3 up_vector(Up up) {
  return up == Up::y ? Vec3::UnitY() : Vec3::UnitZ();
}

Camera aimed_camera(const CameraSettings& settings) {
  const Vec3 up = up_vector(settings.up);
  const Vec3 front = settings.up == Up::y ? Vec3(0, 0, 1) : Vec3(0, -1, 0);
  const Vec3 side = up.cross(front);
  const double a = settings.azimuth, e = settings.elevation;
  const Vec3 outward = std::cos(a) * front + std::sin(a) * side;
  Camera camera;
  camera.right = std::cos(a) * side - std::sin(a) * front;
  camera.forward = -(std::cos(e) * outward + std::sin(e) * up);
  camera.up = std::cos(e) * up - std::sin(e) * outward;
  return camera;
}

Bounds bounds_of(std::span<const Positions> frames) {
  if (frames.empty()) return {};
  Bounds all = bounds_of(frames.front());
  for (const Positions& frame : frames) {
    const Bounds bounds = bounds_of(frame);
    all.min = all.min.cwiseMin(bounds.min);
    all.max = all.max.cwiseMax(bounds.max);
  }
  return all;
}

Camera fit_camera(const CameraSettings& settings, std::span<const Positions> frames, double aspect,
                  Turning turning) {
  check(settings);
  const Bounds bounds = bounds_of(frames);
  require(bounds.min.allFinite() && bounds.max.allFinite(),
          "a frame has a vertex that is not at a finite place");
  Camera camera = aimed_camera(settings);
  camera.aspect = aspect;
  camera.tan_half = std::tan(settings.fov / 2) / settings.zoom;
  camera.centre = settings.look_at.value_or((bounds.min + bounds.max) / 2);
  const Opening opening(settings, aspect);
  const Vec3 middle = camera.centre;
  const bool is_turning = turning == Turning::yes;
  const Positions circles = is_turning ? swept(frames, middle, up_vector(settings.up)) : Positions(0, 3);
  const Reach reach = reach_of(is_turning ? std::span(&circles, 1) : frames, camera, opening);
  if (!std::isfinite(reach.right)) {  // nothing to frame
    camera.position = middle - camera.forward;
  } else if (settings.look_at || is_turning) {
    camera.position = place_behind(camera, opening, reach);
  } else {
    camera.position = evened_place(camera, opening, middle + centred_place(camera, opening, reach), frames);
  }
  // One point alone is framed from any distance: stand off a little.
  const double least = std::max(1e-3 * bounds.diagonal(), 1e-6 * (1 + middle.norm()));
  if ((camera.position - middle).norm() < least) camera.position = middle - least * camera.forward;
  return camera;
}

Camera turned(const Camera& camera, double angle, Up up) {
  const Eigen::AngleAxisd turn(angle, up_vector(up));
  Camera result = camera;
  result.position = camera.centre + turn * (camera.position - camera.centre);
  result.right = turn * camera.right;
  result.up = turn * camera.up;
  result.forward = turn * camera.forward;
  return result;
}

Vec3 project(const Camera& camera, const Vec3& point, int height) {
  const Vec3 p = point - camera.position;
  const double depth = p.dot(camera.forward);
  const double half = height / 2.0;
  const double scale = half / (depth * camera.tan_half);
  return {half * camera.aspect + scale * p.dot(camera.right), half - scale * p.dot(camera.up), depth};
}

}  // namespace flexkey
