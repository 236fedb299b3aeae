#include "flexkey/preview/images/draw.h"

#include <algorithm>
#include <cmath>

#include "flexkey/preview/images/coverage.h"
#include "flexkey/preview/images/image_format.h"

namespace flexkey {
namespace {

std::size_t area(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
  const double along = length > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / length : 0;
  const double t = std::clamp(along, 0.0, 1.0);
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// An empty coverage around the points and `reach` pixels more, cut to the picture.
Coverage coverage_around(const Picture& picture, std::span<const Point> points, double reach) {
  Point low = points.front(), high = points.front();
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const auto first = [&](double value, int end) {
    return static_cast<int>(std::clamp(std::floor(value - reach), 0.0, static_cast<double>(end)));
  };
  const auto last = [&](double value, int end) {
    return static_cast<int>(std::clamp(std::ceil(value + reach), 0.0, static_cast<double>(end)));
  };
  const int left = first(low.x, picture.width), top = first(low.y, picture.height);
  const int width = std::max(0, last(high.x, picture.width) - left);
  const int height = std::max(0, last(high.y, picture.height) - top);
  return {width, height, left, top, std::vector<float>(area(width, height))};
}

/// Adds what a segment covers where that is more than was covered.
void cover_segment(Coverage& coverage, const Point& a, const Point& b, double width) {
  const double reach = width / 2 + 1;
  const auto within = [](double value, int start, int end) {
    return static_cast<int>(std::clamp(std::floor(value) - start, 0.0, static_cast<double>(end)));
  };
  const int first_row = within(std::min(a.y, b.y) - reach, coverage.top, coverage.height);
  const int end_row = within(std::max(a.y, b.y) + reach + 1, coverage.top, coverage.height);
  const int first = within(std::min(a.x, b.x) - reach, coverage.left, coverage.width);
  const int end = within(std::max(a.x, b.x) + reach + 1, coverage.left, coverage.width);
  for (int y = first_row; y < end_row; ++y) {
    for (int x = first; x < end; ++x) {
      const Point middle{coverage.left + x + 0.5, coverage.top + y + 0.5};
      const double share = std::clamp(width / 2 + 0.5 - distance_to_segment(middle, a, b), 0.0, 1.0);
      float& covered = coverage.share[area(y, coverage.width) + static_cast<std::size_t>(x)];
      covered = std::max(covered, static_cast<float>(share * std::min(1.0, width)));
    }
  }
}

}  // namespace

Picture blank_picture(int width, int height, const Rgb& colour) {
  check_picture_size(width, height);
  Picture picture{width, height, {}};
  picture.rgb.reserve(area(width, height) * 3);
  for (std::size_t i = 0; i < area(width, height); ++i)
    picture.rgb.insert(picture.rgb.end(), {colour[0], colour[1], colour[2]});
  return picture;
}

void fill(Picture& picture, const Rectangle& rectangle, const Ink& ink) {
  const int left = std::clamp(rectangle.left, 0, picture.width);
  const int top = std::clamp(rectangle.top, 0, picture.height);
  const int width = std::clamp(rectangle.left + rectangle.width, left, picture.width) - left;
  const int height = std::clamp(rectangle.top + rectangle.height, top, picture.height) - top;
  const Coverage coverage{width, height, 0, 0, std::vector<float>(area(width, height), ink.opacity)};
  lay_over(picture, coverage, left, top, ink.colour);
}

void draw_line(Picture& picture, std::span<const Point> points, double width, const Ink& ink) {
  if (points.empty()) return;
  Coverage coverage = coverage_around(picture, points, width / 2 + 1);
  if (points.size() == 1) cover_segment(coverage, points[0], points[0], width);
  for (std::size_t i = 1; i < points.size(); ++i) cover_segment(coverage, points[i - 1], points[i], width);
  for (float& share : coverage.share) share *= ink.opacity;
  lay_over(picture, coverage, coverage.left, coverage.top, ink.colour);
}

void paste(Picture& picture, const Picture& from, int left, int top) {
  const int first = std::max(0, -left), end = std::min(from.width, picture.width - left);
  for (int y = std::max(0, -top); y < std::min(from.height, picture.height - top) && first < end; ++y) {
    const float* row = &from.rgb[(area(y, from.width) + static_cast<std::size_t>(first)) * 3];
    std::copy_n(row, 3 * (end - first),
                &picture.rgb[(area(top + y, picture.width) + static_cast<std::size_t>(left + first)) * 3]);
  }
}

}  // namespace flexkey
