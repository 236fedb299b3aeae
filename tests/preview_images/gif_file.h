#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace flexkey::test {

/// A GIF with one palette for all its frames, read by the letter of its specification, without giflib.
struct GifFile {
  struct Frame {
    int left = 0, top = 0, width = 0, height = 0;
    int delay = 0;                  // centiseconds
    std::vector<std::uint8_t> rgb;  // the whole screen while it is shown, sRGB
  };
  int width = 0, height = 0;
  int repeats = -1;  // 0: for ever; -1: not said
  std::vector<Frame> frames;
};

/// Throws std::runtime_error at whatever is not as it should be.
GifFile read_gif(const std::filesystem::path& path);

}  // namespace flexkey::test
