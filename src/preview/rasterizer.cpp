#include "flexkey/preview/rasterizer.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace flexkey {
namespace {

using Eigen::Vector3f;

constexpr int kBand = 16;          // rows that one task fills
constexpr float kNearest = 1e-4f;  // depth at which triangles are cut away

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// The triangles that each band of rows touches, in increasing order.
struct Bands {
  std::vector<int> offsets, triangles;
};

struct Rows {
  int first = 0, last = -1;
};

/// The rows whose middles a triangle may cover; none where a corner is behind the camera.
Rows rows_of(const Points& seen, const std::array<int, 3>& corners, int height) {
  const auto [a, b, c] = corners;
  if (std::min({seen(a, 2), seen(b, 2), seen(c, 2)}) < kNearest) return {};
  const float top = std::min({seen(a, 1), seen(b, 1), seen(c, 1)});
  const float bottom = std::max({seen(a, 1), seen(b, 1), seen(c, 1)});
  if (!(bottom >= 0) || !(top <= static_cast<float>(height))) return {};
  return {static_cast<int>(std::max(std::ceil(top - 0.5f), 0.0f)),
          static_cast<int>(std::min(std::floor(bottom - 0.5f), static_cast<float>(height - 1)))};
}

Bands sort_into_bands(const Points& seen, const Surface& surface, int height) {
  Bands bands;
  bands.offsets.assign(index((height + kBand - 1) / kBand) + 1, 0);
  const auto each = [&](auto&& visit) {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const Rows rows = rows_of(seen, surface.triangles[t], height);
      if (rows.first > rows.last) continue;
      for (int band = rows.first / kBand; band <= rows.last / kBand; ++band) visit(band, static_cast<int>(t));
    }
  };
  each([&](int band, int) { ++bands.offsets[index(band) + 1]; });
  for (std::size_t b = 1; b < bands.offsets.size(); ++b) bands.offsets[b] += bands.offsets[b - 1];
  bands.triangles.resize(index(bands.offsets.back()));
  std::vector<int> next(bands.offsets.begin(), bands.offsets.end() - 1);
  each([&](int band, int t) { bands.triangles[index(next[index(band)]++)] = t; });
  return bands;
}

/// a, b, c: pixels and depth. Calls visit(x, y, depth) at the middles that the triangle covers in these rows.
template <class Visit>
void fill(const Vector3f& a, const Vector3f& b, const Vector3f& c, const Rows& rows, int width, Visit visit) {
  const float area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  if (area == 0) return;
  const float left = std::min({a.x(), b.x(), c.x()}), right = std::max({a.x(), b.x(), c.x()});
  if (!(right >= 0) || !(left <= static_cast<float>(width))) return;
  const int first = static_cast<int>(std::max(std::ceil(left - 0.5f), 0.0f));
  const int last = static_cast<int>(std::min(std::floor(right - 0.5f), static_cast<float>(width - 1)));
  const Vector3f inverse(1 / a.z(), 1 / b.z(), 1 / c.z());  // linear over the picture, as depth is not
  for (int y = rows.first; y <= rows.last; ++y) {
    const float py = static_cast<float>(y) + 0.5f;
    for (int x = first; x <= last; ++x) {
      const float px = static_cast<float>(x) + 0.5f;
      const float u = ((px - a.x()) * (c.y() - a.y()) - (py - a.y()) * (c.x() - a.x())) / area;
      const float v = ((b.x() - a.x()) * (py - a.y()) - (b.y() - a.y()) * (px - a.x())) / area;
      if (u < 0 || v < 0 || u + v > 1) continue;
      visit(x, y, 1 / ((1 - u - v) * inverse[0] + u * inverse[1] + v * inverse[2]));
    }
  }
}

/// Calls visit(triangle, x, y, depth) for every covered pixel; bands run side by side.
template <class Visit>
void fill_all(const Points& seen, const Surface& surface, const View& view, Visit visit) {
  const Bands bands = sort_into_bands(seen, surface, view.height);
  tbb::parallel_for(0, static_cast<int>(bands.offsets.size()) - 1, [&](int band) {
    for (int k = bands.offsets[index(band)]; k < bands.offsets[index(band) + 1]; ++k) {
      const int triangle = bands.triangles[index(k)];
      const auto& corners = surface.triangles[index(triangle)];
      Rows rows = rows_of(seen, corners, view.height);
      rows = {std::max(rows.first, band * kBand), std::min(rows.last, band * kBand + kBand - 1)};
      fill(seen.row(corners[0]), seen.row(corners[1]), seen.row(corners[2]), rows, view.width,
           [&](int x, int y, float depth) { visit(triangle, x, y, depth); });
    }
  });
}

Points project_all(const Points& points, const View& view) {
  Points seen(points.rows(), 3);
  tbb::parallel_for(Eigen::Index{0}, points.rows(), [&](Eigen::Index v) {
    seen.row(v) = view.project(points.row(v).transpose()).transpose();
  });
  return seen;
}

void put(Fragment& fragment, const Fragment& candidate) {
  if (fragment.what == Hit::What::nothing || candidate.depth < fragment.depth) fragment = candidate;
}

void draw_wire(const Vector3f& a, const Vector3f& b, int wire, const View& view,
               std::vector<Fragment>& fragments) {
  if (std::min(a.z(), b.z()) < kNearest) return;
  const float length = std::max(std::abs(b.x() - a.x()), std::abs(b.y() - a.y()));
  if (!(length < 1e5f)) return;
  const int steps = static_cast<int>(length) + 1;
  for (int k = 0; k <= steps; ++k) {
    const float share = static_cast<float>(k) / static_cast<float>(steps);
    const Vector3f p = a + share * (b - a);
    if (!(p.x() >= 0 && p.y() >= 0 && p.x() < static_cast<float>(view.width) &&
          p.y() < static_cast<float>(view.height)))
      continue;
    constexpr float nearer = 0.998f;  // lets the line win against the surface that it lies on
    const std::size_t pixel =
        index(static_cast<int>(p.y())) * index(view.width) + index(static_cast<int>(p.x()));
    put(fragments[pixel], {Hit::What::wire, wire, nearer * p.z()});
  }
}

void draw_dot(const Dot& dot, int number, const View& view, std::vector<Fragment>& fragments) {
  const Vector3f middle = view.project(dot.centre);
  if (middle.z() < kNearest) return;
  const float radius = dot.radius / (middle.z() * view.step);
  const auto clamped = [](float x, int size) {
    return static_cast<int>(std::clamp(x, 0.0f, static_cast<float>(size)));
  };
  for (int y = clamped(middle.y() - radius, view.height); y < clamped(middle.y() + radius + 1, view.height);
       ++y) {
    for (int x = clamped(middle.x() - radius, view.width); x < clamped(middle.x() + radius + 1, view.width);
         ++x) {
      const float dx = static_cast<float>(x) + 0.5f - middle.x(),
                  dy = static_cast<float>(y) + 0.5f - middle.y();
      const float rest = radius * radius - dx * dx - dy * dy;
      if (rest < 0) continue;
      const float depth = middle.z() - dot.radius * std::sqrt(rest) / radius;
      put(fragments[index(y) * index(view.width) + index(x)], {Hit::What::dot, number, depth});
    }
  }
}

}  // namespace

std::vector<Fragment> rasterize(const DrawnFrame& frame, const View& view) {
  std::vector<Fragment> fragments(index(view.width) * index(view.height));
  const Points seen = project_all(frame.points, view);
  fill_all(seen, frame.surface, view, [&](int triangle, int x, int y, float depth) {
    put(fragments[index(y) * index(view.width) + index(x)], {Hit::What::surface, triangle, depth});
  });
  const std::size_t wires = frame.wire_radius > 0 ? frame.surface.wires.size() : 0;
  for (std::size_t k = 0; k < wires; ++k) {
    const auto [a, b] = frame.surface.wires[k];
    draw_wire(seen.row(a), seen.row(b), static_cast<int>(k), view, fragments);
  }
  for (std::size_t k = 0; k < frame.dots.size(); ++k)
    draw_dot(frame.dots[k], static_cast<int>(k), view, fragments);
  return fragments;
}

std::vector<char> rasterize_shadow(const DrawnFrame& frame, const View& view, const Light& light) {
  std::vector<char> shadow(index(view.width) * index(view.height), 0);
  Points fallen = frame.points;
  const Vector3f slope = light.key / light.key.dot(light.up);
  tbb::parallel_for(Eigen::Index{0}, fallen.rows(), [&](Eigen::Index v) {
    const float height = fallen.row(v).dot(light.up) - light.floor;
    fallen.row(v) -= height * slope.transpose();
  });
  fill_all(project_all(fallen, view), frame.surface, view,
           [&](int, int x, int y, float) { shadow[index(y) * index(view.width) + index(x)] = 1; });
  return shadow;
}

}  // namespace flexkey
