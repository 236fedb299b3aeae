#pragma once

#include <cstdint>
#include <vector>

#include "flexkey/preview/images/palette.h"

namespace flexkey {

/// Paints pictures with a palette's colours. Between two colours it strews the one among the other in a
/// pattern that is fixed on the screen (Bayer's 8 x 8), so that what does not move keeps its pixels from
/// frame to frame.
class Dither {
 public:
  /// colours: 1 .. 255.
  explicit Dither(std::vector<Srgb> colours);

  /// The palette index for a colour at a pixel.
  std::uint8_t index(const std::uint8_t* rgb, int x, int y);

 private:
  /// The best two colours for a target, and how much of 64 the second has.
  struct Mix {
    std::uint8_t first = 0, second = 0, share = 0;
    bool known = false;
  };
  Mix best_mix(const Srgb& target) const;

  std::vector<Srgb> colours_;
  std::vector<Mix> mixes_;  // by the target's upper 7 bits a channel, made where first asked for
};

}  // namespace flexkey
