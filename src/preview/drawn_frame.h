#pragma once

#include <vector>

#include "flexkey/preview/light.h"
#include "flexkey/preview/render_options.h"
#include "flexkey/preview/surface.h"

namespace flexkey {

/// A small sphere that marks a vertex, in unit space.
struct Dot {
  Eigen::Vector3f centre;
  float radius = 0;
  Rgb colour;
};

/// The colours of the surface in one frame.
struct Paint {
  Style style = Style::clay;
  Rgb base;                      // where nothing below says otherwise
  std::vector<Rgb> of_vertex;    // #vertices of the surface, or empty
  std::vector<Rgb> of_material;  // #materials, or empty
  const Mesh* mesh = nullptr;    // whose face_material is read
  const TextureLookup* texture = nullptr;
};

/// One frame, ready for either quality. Everything in unit space.
struct DrawnFrame {
  const Surface& surface;
  Points points, normals;  // #vertices of the surface x 3
  Paint paint;
  std::vector<Dot> dots;
  float wire_radius = 0;  // 0: no wires
};

/// What a ray met first.
struct Hit {
  enum class What { nothing, surface, wire, dot };
  What what = What::nothing;
  int index = -1;      // triangle, wire or dot
  float u = 0, v = 0;  // of a triangle: weights of its second and third corner
  float distance = 0;  // along the ray's unit direction
};

struct Ray {
  Eigen::Vector3f origin, direction;
};

/// The spot that was met, with its colour in the frame's style; `hit` is not nothing.
Spot spot_at(const DrawnFrame& frame, const View& view, const Hit& hit, const Ray& ray);

}  // namespace flexkey
