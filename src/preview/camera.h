#pragma once

#include <numbers>
#include <optional>
#include <span>

#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// The world's vertical axis. The camera never rolls against it.
enum class Up { y, z };
Vec3 up_vector(Up up);

/// What a shot says of the camera. Angles in radians, lengths in mesh units.
struct CameraSettings {
  std::optional<Vec3> look_at;  // what lies in the middle; default: the middle of what is framed
  double azimuth = 35 * std::numbers::pi / 180;    // 0 looks from +z (up y) or -y (up z); grows towards +x
  double elevation = 15 * std::numbers::pi / 180;  // above the horizon, -90 .. 90 degrees
  double fov = 30 * std::numbers::pi / 180;        // of the picture's height, 0 .. 180 degrees
  double zoom = 1;                                 // enlarges what fits
  double margin = 0.08;                            // left free at each side, a share of the picture
  double footer = 0;  // left free at the lower edge beside the margin, a share of the height, below 0.5
  Up up = Up::y;
};

/// A pinhole camera in mesh units.
struct Camera {
  Vec3 position{0, 0, 1};
  Vec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};  // orthonormal; right is level
  Vec3 centre{0, 0, 0};                                 // what it turns about
  double tan_half = 0.27;    // half the picture's height, at a distance of one along `forward`
  double aspect = 16.0 / 9;  // width / height
};

/// The axes of a camera that looks down from `elevation` at `azimuth`, at no place yet.
Camera aimed_camera(const CameraSettings& settings);

/// The camera that holds all rows of `frames` in the picture. `aspect` is width / height; `turning` makes
/// room for all azimuths, for a turntable. Throws InputError for angles out of range or points that are not
/// finite.
enum class Turning { no, yes };
Camera fit_camera(const CameraSettings& settings, std::span<const Positions> frames, double aspect,
                  Turning turning = Turning::no);

/// The camera led around its centre, about the vertical, by `angle` radians towards +azimuth.
Camera turned(const Camera& camera, double angle, Up up);

/// Where a point is seen: x, y in pixels from the top left corner of a picture of this height, and its
/// distance along `forward`, positive in front.
Vec3 project(const Camera& camera, const Vec3& point, int height);

/// Bounds over all frames, for the ground and the light.
Bounds bounds_of(std::span<const Positions> frames);

}  // namespace flexkey
