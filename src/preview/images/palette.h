#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace flexkey {

/// An sRGB colour, each channel 0..255.
using Srgb = std::array<float, 3>;

/// Counts the colours of a clip in cells of 4 x 4 x 4 values, 64 cells a channel.
class ColourCount {
 public:
  ColourCount();
  /// rgb: sRGB, 3 values a pixel.
  void add(const std::vector<std::uint8_t>& rgb);

  /// The mean colour of a cell, and how much it counts for a palette: the root of its pixels, so that a
  /// small coloured mark keeps a colour beside a large background.
  struct Sample {
    Srgb colour;
    float weight;
  };
  std::vector<Sample> samples() const;

 private:
  struct Cell {
    std::uint64_t pixels = 0;
    std::array<std::uint64_t, 3> sum{};
  };
  std::vector<Cell> cells_;
};

/// At most `most` colours that serve the samples well: boxes of them are split, worst first, across their
/// widest channel (median cut by variance), then moved to the means of what is nearest to them (Lloyd).
std::vector<Srgb> make_palette(std::vector<ColourCount::Sample> samples, std::size_t most);

}  // namespace flexkey
