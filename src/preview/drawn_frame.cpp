#include "flexkey/preview/drawn_frame.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace flexkey {
namespace {

using Eigen::Vector3f;

const Rgb kWire = from_srgb({0.17f, 0.20f, 0.25f});

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// A triangle's values at its corners, blended.
template <class Value, class Corner>
Value blend(const Hit& hit, Corner corner) {
  return Value((1 - hit.u - hit.v) * corner(0) + hit.u * corner(1) + hit.v * corner(2));
}

Rgb material_colour(const DrawnFrame& frame, const Hit& hit) {
  const Paint& paint = frame.paint;
  const int face = frame.surface.face_of[index(hit.index)];
  const int material = paint.mesh->face_material[index(face)];
  if (material < 0) return paint.base;
  const bool has_texture = !paint.mesh->materials[index(material)].texture.empty();
  if (!has_texture || !*paint.texture || frame.surface.texcoords.empty())
    return paint.of_material[index(material)];
  const auto& uvs = frame.surface.texcoords[index(hit.index)];
  return (*paint.texture)(material, blend<Eigen::Vector2f>(hit, [&](std::size_t k) { return uvs[k]; }));
}

/// As three.js and matcaps have it: x right, y up, z towards the viewer, 0..1 as stored in an image.
Rgb normal_colour(const Vector3f& n, const View& view) {
  const Vector3f seen(n.dot(view.right), n.dot(view.up), -n.dot(view.forward));
  return from_srgb((seen.array() * 0.5f + 0.5f).cwiseMax(0).matrix());
}

Rgb surface_colour(const DrawnFrame& frame, const Hit& hit) {
  const Paint& paint = frame.paint;
  if (!paint.of_material.empty()) return material_colour(frame, hit);
  if (paint.of_vertex.empty()) return paint.base;
  const auto& corners = frame.surface.triangles[index(hit.index)];
  return blend<Rgb>(hit, [&](std::size_t k) { return paint.of_vertex[index(corners[k])]; });
}

Spot surface_spot(const DrawnFrame& frame, const View& view, const Hit& hit, const Ray& ray) {
  const auto& corners = frame.surface.triangles[index(hit.index)];
  const auto point = [&](std::size_t k) -> Vector3f { return frame.points.row(corners[k]); };
  Spot spot;
  spot.view = -ray.direction;
  spot.position = blend<Vector3f>(hit, point);
  spot.face = (point(1) - point(0)).cross(point(2) - point(0)).stableNormalized();
  spot.normal =
      blend<Vector3f>(hit, [&](std::size_t k) -> Vector3f { return frame.normals.row(corners[k]); });
  spot.normal = spot.normal.squaredNorm() > 0 ? Vector3f(spot.normal.normalized()) : spot.face;
  if (spot.face.dot(spot.view) < 0) {  // seen from inside, through an opening
    spot.face = -spot.face;
    spot.normal = -spot.normal;
  }
  spot.is_lit = frame.paint.style != Style::normals;
  spot.colour = spot.is_lit ? surface_colour(frame, hit) : normal_colour(spot.normal, view);
  return spot;
}

}  // namespace

Spot spot_at(const DrawnFrame& frame, const View& view, const Hit& hit, const Ray& ray) {
  if (hit.what == Hit::What::surface) return surface_spot(frame, view, hit, ray);
  Spot spot;
  spot.view = spot.normal = spot.face = -ray.direction;
  spot.position = ray.origin + hit.distance * ray.direction;
  spot.colour = kWire;
  if (hit.what == Hit::What::dot) {
    const Dot& dot = frame.dots[index(hit.index)];
    spot.normal = spot.face = (spot.position - dot.centre).normalized();
    spot.colour = dot.colour;
  } else {
    spot.is_lit = false;  // a pen's line, not a thread in the light
  }
  return spot;
}

}  // namespace flexkey
