#pragma once

#include <cstdint>
#include <vector>

#include "flexkey/preview/images/dither.h"
#include "flexkey/preview/images/module.h"

namespace flexkey {

/// Turns the pictures of a clip into what changes from each to the next, in the colours of one palette.
class GifFrames {
 public:
  /// colours: at most 255, whole numbers.
  GifFrames(int width, int height, const std::vector<Srgb>& colours);

  const GifScreen& screen() const { return screen_; }
  /// rgb: sRGB, width * height * 3.
  GifFrame next(const std::vector<std::uint8_t>& rgb, int delay);

 private:
  bool changes(std::size_t pixel, const std::vector<std::uint8_t>& rgb);

  GifScreen screen_;
  Dither dither_;
  std::vector<std::uint8_t> shown_;  // palette indices on the screen; gif_transparent before the first frame
  std::vector<std::uint8_t> meant_;  // the colours that they stand for, sRGB
};

}  // namespace flexkey
