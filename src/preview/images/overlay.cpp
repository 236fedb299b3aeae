#include "flexkey/preview/images/overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "flexkey/preview/images/draw.h"
#include "flexkey/preview/images/text.h"

namespace flexkey {
namespace {

/// The band's measures, in pixels, all from the picture's height.
struct Band {
  int top = 0, height = 0;
  int margin = 0;
  int text_size = 0;
  double line = 1;  // the curve's width
};

Band band_of(const Picture& picture) {
  const int height = overlay_height(picture.height);
  return {picture.height - height, height, height * 2 / 5, std::max(9, height * 7 / 20),
          std::max(1.0, height / 24.0)};
}

struct Colours {
  Rgb band = colour_from_srgb(255, 255, 255);
  Rgb text = colour_from_srgb(38, 38, 44);
  Rgb quiet = colour_from_srgb(128, 128, 134);
  Rgb now = colour_from_srgb(214, 86, 18);
};

/// Writes what is said of now, in columns as wide as any moment of the clip needs; returns where it ends.
int write_moment(Picture& picture, const Band& band, const Moment& last, const Moment& now) {
  const Colours colours;
  const int baseline = band.top + (band.height + digit_height(band.text_size)) / 2;
  int x = band.margin;
  const auto column = [&](const std::string& text, const std::string& widest, const Rgb& colour) {
    x += text_width(widest, band.text_size);
    write_text(picture, x, baseline, text, {band.text_size, colour, Align::right});
    x += band.margin;
  };
  const auto time = [](double seconds) { return fmt::format("{:.2f} s", seconds); };
  column(time(now.time), time(std::max(last.time, now.time)), colours.text);
  const int most = std::max(last.frame, now.frame);
  column(fmt::format("frame {}", now.frame), fmt::format("frame {}", most), colours.quiet);
  column(fmt::format("λ {:.2f}", now.lambda), "λ 0.00", colours.now);
  return x;
}

/// Where a moment lies in the strip.
struct Strip {
  double left = 0, right = 0, top = 0, bottom = 0;
  double start = 0, end = 0;  // seconds
  Point at(double time, double lambda) const {
    const double along = end > start ? std::clamp((time - start) / (end - start), 0.0, 1.0) : 0;
    return {left + along * (right - left), bottom - std::clamp(lambda, 0.0, 1.0) * (bottom - top)};
  }
};

void draw_curve(Picture& picture, const Strip& strip, const std::vector<Moment>& clip, const Moment& now,
                double width) {
  const Colours colours;
  for (const double lambda : {0.0, 1.0}) {
    const Point ends[2] = {strip.at(strip.start, lambda), strip.at(strip.end, lambda)};
    draw_line(picture, ends, 1, {colours.quiet, 0.25f});
  }
  std::vector<Point> all, past;
  for (const Moment& moment : clip) {
    all.push_back(strip.at(moment.time, moment.lambda));
    if (moment.time < now.time) past.push_back(all.back());
  }
  past.push_back(strip.at(now.time, now.lambda));
  draw_line(picture, all, width, {colours.quiet, 0.8f});
  draw_line(picture, past, width, {colours.text});
  const Point playhead[2] = {strip.at(now.time, 0), strip.at(now.time, 1)};
  draw_line(picture, playhead, width, {colours.now, 0.7f});
  const Point dot[1] = {past.back()};
  draw_line(picture, dot, 4 * width, {colours.now});
}

}  // namespace

int overlay_height(int picture_height) {
  return std::max(18, picture_height * 2 / 27);
}

void draw_overlay(Picture& picture, const std::vector<Moment>& clip, const Moment& now) {
  const Band band = band_of(picture);
  fill(picture, {0, band.top, picture.width, band.height}, {Colours().band, 0.65f});
  const int end = write_moment(picture, band, clip.back(), now);
  const double inset = band.height * 0.2;
  const Strip strip{end + 0.5,         picture.width - band.margin - 0.5,
                    band.top + inset,  picture.height - inset,
                    clip.front().time, clip.back().time};
  if (strip.right - strip.left < 2 * band.height) return;  // no room for a curve that one could read
  draw_curve(picture, strip, clip, now, band.line);
}

}  // namespace flexkey
