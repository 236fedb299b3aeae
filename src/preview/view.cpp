#include "flexkey/preview/view.h"

namespace flexkey {

UnitSpace::UnitSpace(const Bounds& bounds) : centre((bounds.min + bounds.max) / 2) {
  const double diagonal = bounds.diagonal();
  if (diagonal > 0) scale = 1 / diagonal;
}

View::View(const Camera& camera, const UnitSpace& space, int pixels_across, int pixels_along)
    : width(pixels_across),
      height(pixels_along),
      origin(space.place(camera.position)),
      right(camera.right.cast<float>()),
      up(camera.up.cast<float>()),
      forward(camera.forward.cast<float>()),
      step(static_cast<float>(2 * camera.tan_half / pixels_along)) {}

Eigen::Vector3f View::direction(float x, float y) const {
  const float across = (x - static_cast<float>(width) / 2) * step;
  const float along = (static_cast<float>(height) / 2 - y) * step;
  return (forward + across * right + along * up).normalized();
}

Eigen::Vector3f View::project(const Eigen::Vector3f& p) const {
  const Eigen::Vector3f q = p - origin;
  const float depth = q.dot(forward);
  const float scale = 1 / (depth * step);
  return {static_cast<float>(width) / 2 + scale * q.dot(right),
          static_cast<float>(height) / 2 - scale * q.dot(up), depth};
}

}  // namespace flexkey
