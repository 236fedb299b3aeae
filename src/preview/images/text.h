#pragma once

#include <string>

#include "flexkey/preview/colour.h"
#include "flexkey/preview/picture.h"

namespace flexkey {

enum class Align { left, centre, right };

struct TextStyle {
  int size = 14;  // of the em, pixels
  Rgb colour = Rgb::Zero();
  Align align = Align::left;
};

/// Writes one line in DejaVu Sans, dark on a light ground, (UTF-8) with `x` at its start, middle or end; what
/// lies outside is cut. Throws OutputError if the font is not installed.
void write_text(Picture& picture, int x, int baseline, const std::string& text, const TextStyle& style);

/// The line's width in pixels.
int text_width(const std::string& text, int size);

/// The height of capitals and digits of this size, pixels.
int digit_height(int size);

}  // namespace flexkey
