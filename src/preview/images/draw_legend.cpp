#include "flexkey/preview/images/draw_legend.h"

#include <fmt/format.h>

#include <algorithm>

#include "flexkey/preview/images/draw.h"
#include "flexkey/preview/images/text.h"

namespace flexkey {
namespace {

void draw_bar(Picture& picture, const Rectangle& bar, const std::function<Rgb(float)>& colour) {
  for (int x = 0; x < bar.width; ++x) {
    const float share = (static_cast<float>(x) + 0.5f) / static_cast<float>(bar.width);
    fill(picture, {bar.left + x, bar.top, 1, bar.height}, {colour(share)});
  }
}

}  // namespace

void draw_legend(Picture& picture, const Legend& legend) {
  const int unit = std::max(9, picture.height * 7 / 270);  // the text's size; all else follows
  const int line = digit_height(unit), space = unit * 2 / 3;
  const std::string low = fmt::format("{:.3g}", legend.low), high = fmt::format("{:.3g}", legend.high);
  const int width = std::max({12 * unit, text_width(legend.title, unit),
                              text_width(low, unit) + text_width(high, unit) + 2 * space});
  const Rectangle bar{picture.width - width - 2 * space,
                      2 * space + (legend.title.empty() ? 0 : line + space), width, unit};
  const int bottom = bar.top + bar.height + space + line;
  fill(picture, {bar.left - space, space, width + 2 * space, bottom},
       {colour_from_srgb(255, 255, 255), 0.65f});
  draw_bar(picture, bar, legend.colour);

  const Rgb text = colour_from_srgb(38, 38, 44);
  if (!legend.title.empty()) write_text(picture, bar.left, bar.top - space, legend.title, {unit, text});
  write_text(picture, bar.left, bottom, low, {unit, text});
  write_text(picture, bar.left + width, bottom, high, {unit, text, Align::right});
}

}  // namespace flexkey
