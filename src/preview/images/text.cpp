#include "flexkey/preview/images/text.h"

#include <cmath>

#include "flexkey/preview/images/module.h"

namespace flexkey {

void write_text(Picture& picture, int x, int baseline, const std::string& text, const TextStyle& style) {
  Coverage coverage = image_module().text_coverage(text, style.size);
  // Mixed in linear light, dark letters look thinner than they are drawn.
  for (float& share : coverage.share) share = std::pow(share, 0.7f);
  const int end = coverage.left + coverage.width;  // from the line's start
  const int shift = style.align == Align::left ? 0 : style.align == Align::centre ? end / 2 : end;
  lay_over(picture, coverage, x - shift + coverage.left, baseline + coverage.top, style.colour);
}

int text_width(const std::string& text, int size) {
  const Coverage coverage = image_module().text_coverage(text, size);
  return coverage.left + coverage.width;
}

int digit_height(int size) {
  return -image_module().text_coverage("0", size).top;
}

}  // namespace flexkey
