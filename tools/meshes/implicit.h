#pragma once

#include "quad_mesh.h"

#include <functional>
#include <vector>

namespace flexkey::meshes {

// About the signed distance to a shape: negative inside.
using Field = std::function<double(const Vec3&)>;

Field ellipsoid(const Vec3& centre, const Vec3& radii);

// Ellipsoid whose axes are turned by the angles (degrees, about x, then y, then z).
Field ellipsoid(const Vec3& centre, const Vec3& radii, const Vec3& degrees);

// A ball swept from a to b while its radius goes from ra to rb.
Field round_cone(const Vec3& a, double ra, const Vec3& b, double rb);

struct Ball {
  Vec3 centre;
  double radius;
};

// A tube along a smooth curve through the balls.
Field chain(const std::vector<Ball>& balls);

// The shape squeezed by a factor an axis about a centre.
Field squeezed(const Field& field, const Vec3& centre, const Vec3& factors);

// Everything on the side of the plane that `normal` points away from.
Field half_space(const Vec3& point, const Vec3& normal);

// Clay: shapes are blended on and carved off in turn. Shapes are given for x >= 0 only; the field
// is even in x, with the fold rounded so that no crease runs along the middle.
class Clay {
 public:
  Clay& add(Field shape, double k);
  Clay& carve(Field shape, double k);
  // Keeps only what lies inside the shape.
  Clay& keep(Field shape, double k);

  double value(const Vec3& p) const;
  Vec3 gradient(const Vec3& p) const;

  // The surface point that steps along the gradient lead to.
  Vec3 on_surface(const Vec3& p) const;

  // First point on the surface met from p towards -z, or p itself when nothing is there.
  Vec3 cast_back(const Vec3& p) const;

 private:
  enum class Action { kAdd, kCarve, kKeep };
  struct Step {
    Field shape;
    double k;
    Action action;
  };
  std::vector<Step> steps_;
};

}  // namespace flexkey::meshes
