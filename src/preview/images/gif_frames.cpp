#include "flexkey/preview/images/gif_frames.h"

#include <algorithm>
#include <cstdlib>

namespace flexkey {
namespace {

constexpr int still = 2;  // values of 255 by which a pixel may drift before it is painted again

std::vector<std::uint8_t> palette_of(const std::vector<Srgb>& colours) {
  std::vector<std::uint8_t> palette(256 * 3);
  for (std::size_t i = 0; i < colours.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) palette[3 * i + c] = static_cast<std::uint8_t>(colours[i][c]);
  return palette;
}

}  // namespace

GifFrames::GifFrames(int width, int height, const std::vector<Srgb>& colours)
    : screen_{width, height, palette_of(colours)},
      dither_(colours),
      shown_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), gif_transparent),
      meant_(shown_.size() * 3) {}

bool GifFrames::changes(std::size_t pixel, const std::vector<std::uint8_t>& rgb) {
  if (shown_[pixel] == gif_transparent) return true;
  for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
    if (std::abs(rgb[i] - meant_[i]) > still) return true;
  return false;
}

GifFrame GifFrames::next(const std::vector<std::uint8_t>& rgb, int delay) {
  const int width = screen_.width;
  std::vector<std::uint8_t> update(shown_.size(), gif_transparent);
  int left = width, right = 0, top = screen_.height, bottom = 0;  // of what changes, ends exclusive
  for (std::size_t pixel = 0; pixel < shown_.size(); ++pixel) {
    if (!changes(pixel, rgb)) continue;
    const int x = static_cast<int>(pixel) % width, y = static_cast<int>(pixel) / width;
    std::copy_n(&rgb[3 * pixel], 3, &meant_[3 * pixel]);
    const std::uint8_t index = dither_.index(&rgb[3 * pixel], x, y);
    if (index == shown_[pixel]) continue;
    shown_[pixel] = update[pixel] = index;
    left = std::min(left, x);
    right = std::max(right, x + 1);
    top = std::min(top, y);
    bottom = y + 1;
  }
  if (right == 0) return {0, 0, 1, 1, delay, {gif_transparent}};  // a still frame has a pixel all the same

  GifFrame frame{left, top, right - left, bottom - top, delay, {}};
  for (int y = top; y < bottom; ++y) {
    const auto row = update.begin() + static_cast<std::ptrdiff_t>(y) * width;
    frame.pixels.insert(frame.pixels.end(), row + left, row + right);
  }
  return frame;
}

}  // namespace flexkey
