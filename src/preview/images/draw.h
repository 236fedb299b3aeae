#pragma once

#include <span>

#include "flexkey/preview/colour.h"
#include "flexkey/preview/picture.h"

namespace flexkey {

/// In pixels from the picture's upper left corner; pixel (0, 0) has its middle at (0.5, 0.5).
struct Point {
  double x = 0, y = 0;
};

struct Rectangle {
  int left = 0, top = 0, width = 0, height = 0;
};

/// A colour laid over what was there; opacity 1 hides it.
struct Ink {
  Rgb colour;
  float opacity = 1;
};

/// A picture of one colour. Throws InputError for a size that no picture can have.
Picture blank_picture(int width, int height, const Rgb& colour);

/// What lies outside the picture is cut, here and below.
void fill(Picture& picture, const Rectangle& rectangle, const Ink& ink);

/// A line through the points with round ends and joints, `width` pixels wide, anti-aliased.
void draw_line(Picture& picture, std::span<const Point> points, double width, const Ink& ink);

/// Copies `from` into the picture with its upper left corner at (left, top).
void paste(Picture& picture, const Picture& from, int left, int top);

}  // namespace flexkey
