#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "flexkey/preview/images/coverage.h"
#include "flexkey/preview/images/image_format.h"
#include "flexkey/preview/picture.h"

namespace flexkey {

using Bytes = std::vector<std::byte>;

/// A file's picture and the line that describes it (empty where it has none).
struct DescribedPicture {
  Picture picture;
  std::string description;
};

/// What every frame of a GIF shares.
struct GifScreen {
  int width = 0, height = 0;
  std::vector<std::uint8_t> palette;  // 256 * 3, sRGB; the colour `gif_transparent` is never shown
};
inline constexpr std::uint8_t gif_transparent = 255;

/// A rectangle of a GIF's screen that changes. Pixels of `gif_transparent` stay as they were.
struct GifFrame {
  int left = 0, top = 0, width = 0, height = 0;
  int delay = 0;                     // centiseconds until the next frame
  std::vector<std::uint8_t> pixels;  // width * height, palette indices
};

/// What the module flexkey_images does for us, so that OpenImageIO is loaded only where a picture is made.
struct ImageModule {
  const char* version;  // of flexkey
  Bytes (*encode)(const Picture&, ImageFormat, const std::string& description);
  DescribedPicture (*decode)(const std::filesystem::path&);
  std::string (*read_description)(const std::filesystem::path&);
  Picture (*resize)(const Picture&, int width, int height);
  Coverage (*text_coverage)(const std::string& text, int size);
  /// Asks `next` for frames until it says false; gives the file to `sink` piece by piece.
  void (*write_gif)(const GifScreen&, const std::function<bool(GifFrame&)>& next,
                    const std::function<void(std::span<const std::byte>)>& sink);
};

/// Loads the module on the first call. It lies beside the program, or under the prefix in which the program
/// is installed, or in the folder that the environment's FLEXKEY_MODULES names. Throws OutputError with the
/// package to install if it or OpenImageIO is not there.
const ImageModule& image_module();

}  // namespace flexkey
