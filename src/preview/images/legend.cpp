#include "flexkey/preview/images/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "flexkey/preview/images/draw.h"
#include "flexkey/preview/images/srgb.h"
#include "flexkey/preview/images/text.h"

namespace flexkey {
namespace {

/// Between the colours on either side; position: 0 is the first, 1 the last.
Colour colour_at(const std::vector<Colour>& colours, double position) {
  const double place = position * static_cast<double>(colours.size() - 1);
  const auto before = std::min(static_cast<std::size_t>(place), colours.size() - 1);
  const auto after = std::min(before + 1, colours.size() - 1);
  const auto share = static_cast<float>(place - std::floor(place));
  const Colour &a = colours[before], &b = colours[after];
  return {std::lerp(a.red, b.red, share), std::lerp(a.green, b.green, share),
          std::lerp(a.blue, b.blue, share)};
}

void draw_bar(Picture& picture, const Rectangle& bar, const std::vector<Colour>& colours) {
  for (int x = 0; x < bar.width; ++x) {
    const double position = (x + 0.5) / bar.width;
    fill(picture, {bar.left + x, bar.top, 1, bar.height}, {colour_at(colours, position)});
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
  fill(picture, {bar.left - space, space, width + 2 * space, bottom}, {colour_from_srgb(18, 18, 22), 0.95f});
  draw_bar(picture, bar, legend.colours);

  const Colour text = colour_from_srgb(240, 240, 240);
  if (!legend.title.empty()) write_text(picture, bar.left, bar.top - space, legend.title, {unit, text});
  write_text(picture, bar.left, bottom, low, {unit, text});
  write_text(picture, bar.left + width, bottom, high, {unit, text, Align::right});
}

}  // namespace flexkey
