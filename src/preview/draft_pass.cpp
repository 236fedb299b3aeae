#include "flexkey/preview/draft_pass.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "flexkey/preview/rasterizer.h"

namespace flexkey {
namespace {

using Eigen::Vector3f;

constexpr float kDraftSky = 0.85f;     // stands for ambient occlusion
constexpr float kDraftShadow = 0.35f;  // stands for the soft edge of the shadow

/// A fragment as a ray would have met it.
Hit hit_of(const Fragment& fragment, const DrawnFrame& frame, const View& view, const Ray& ray) {
  Hit hit;
  hit.what = fragment.what;
  hit.index = fragment.index;
  hit.distance = fragment.depth / ray.direction.dot(view.forward);
  if (hit.what != Hit::What::surface) return hit;
  const auto& corners = frame.surface.triangles[static_cast<std::size_t>(fragment.index)];
  const Vector3f a = frame.points.row(corners[0]);
  const Vector3f ab = frame.points.row(corners[1]).transpose() - a,
                 ac = frame.points.row(corners[2]).transpose() - a;
  const Vector3f p = ray.origin + hit.distance * ray.direction - a;
  const Vector3f area = ab.cross(ac);
  const float whole = area.squaredNorm();
  if (whole > 0) {
    hit.u = std::clamp(p.cross(ac).dot(area) / whole, 0.0f, 1.0f);
    hit.v = std::clamp(ab.cross(p).dot(area) / whole, 0.0f, 1 - hit.u);
  }
  return hit;
}

Rgb ground_colour(const Studio& studio, const Ray& ray, const Rgb& behind, bool is_shadowed) {
  const float distance = ground_distance(studio.light, ray);
  if (distance < 0) return behind;
  const Reached reached{is_shadowed ? kDraftShadow : 1.0f, is_shadowed ? kDraftSky : 1.0f};
  return ground_response(behind, (ray.origin + distance * ray.direction).norm()).under(reached);
}

}  // namespace

Picture draft_picture(const Studio& studio) {
  const View& view = studio.view;
  const std::vector<Fragment> fragments = rasterize(studio.frame, view);
  const std::vector<char> shadow = rasterize_shadow(studio.frame, view, studio.light);
  Picture picture{view.width, view.height, {}};
  picture.rgb.resize(3 * fragments.size());
  tbb::parallel_for(0, view.height, [&](int row) {
    for (int column = 0; column < view.width; ++column) {
      const float x = static_cast<float>(column) + 0.5f, y = static_cast<float>(row) + 0.5f;
      const std::size_t pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(view.width) +
                                static_cast<std::size_t>(column);
      const Ray ray{view.origin, view.direction(x, y)};
      Eigen::Map<Rgb> colour(picture.rgb.data() + 3 * pixel);
      if (fragments[pixel].what == Hit::What::nothing) {
        const Rgb behind = backdrop(view, column, row);
        colour = ground_colour(studio, ray, behind, shadow[pixel] != 0);
      } else {
        const Hit hit = hit_of(fragments[pixel], studio.frame, view, ray);
        const Spot spot = spot_at(studio.frame, view, hit, ray);
        colour = spot_response(studio.light, spot).under({1, kDraftSky});
      }
    }
  });
  return picture;
}

}  // namespace flexkey
