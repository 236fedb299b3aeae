#pragma once

#include <cmath>

#include "flexkey/preview/renderer.h"
#include "support/meshes.h"

namespace flexkey {

/// Small pictures of one mesh at rest.
struct Sitting {
  Mesh mesh;
  RenderOptions options;
  CameraSettings settings;

  Camera camera() const {
    return fit_camera(settings, std::span(&mesh.positions, 1),
                      static_cast<double>(options.width) / options.height);
  }
  Picture take() const {
    return Renderer(mesh, bounds_of(mesh.positions), options).render({mesh.positions}, camera());
  }
};

inline Sitting sitting(Mesh mesh) {
  Sitting result{std::move(mesh), {}, {}};
  result.options.width = 96;
  result.options.height = 64;
  result.options.samples = 4;
  result.options.subdivide = 1;
  return result;
}

inline Rgb pixel(const Picture& picture, int x, int y) {
  const std::size_t first = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                 static_cast<std::size_t>(x));
  return {picture.rgb.at(first), picture.rgb.at(first + 1), picture.rgb.at(first + 2)};
}

inline float brightness(const Rgb& colour) {
  return colour.mean();
}

/// Pixels that differ by more than `tolerance` in a component.
inline int differing(const Picture& a, const Picture& b, float tolerance) {
  int count = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x)
      count += (pixel(a, x, y) - pixel(b, x, y)).cwiseAbs().maxCoeff() > tolerance ? 1 : 0;
  }
  return count;
}

/// Whether a clay surface is at a pixel: the backdrop is nearly grey, clay is not.
inline bool is_clay(const Rgb& colour) {
  return colour.x() > 1.12f * colour.z();
}

}  // namespace flexkey
