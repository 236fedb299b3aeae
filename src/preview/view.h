#pragma once

#include "flexkey/preview/camera.h"
#include "flexkey/preview/surface.h"

namespace flexkey {

/// Mesh space, moved and scaled so that the bounds of the clip lie around the origin with a diagonal of one:
/// single precision then suffices, and lengths of the light are shares of the diagonal.
struct UnitSpace {
  Vec3 centre{0, 0, 0};
  double scale = 1;

  explicit UnitSpace(const Bounds& bounds);
  Eigen::Vector3f place(const Vec3& p) const { return ((p - centre) * scale).cast<float>(); }
};

/// A camera in unit space over the pixels of a picture.
struct View {
  int width = 0, height = 0;
  Eigen::Vector3f origin, right, up, forward;
  float step = 0;  // width of a pixel at a distance of one

  View(const Camera& camera, const UnitSpace& space, int pixels_across, int pixels_along);

  /// Unit direction through a place in pixels from the top left corner.
  Eigen::Vector3f direction(float x, float y) const;
  /// Pixels x, y and the distance along `forward`.
  Eigen::Vector3f project(const Eigen::Vector3f& p) const;
};

}  // namespace flexkey
