#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "flexkey/preview/images/image_format.h"

namespace flexkey {

/// A folder of numbered pictures: 0000.png, 0001.png …
struct PictureSequence {
  std::filesystem::path folder;
  ImageFormat format = ImageFormat::png;
};

/// The file of frame k.
std::filesystem::path frame_path(const PictureSequence& sequence, int frame);

/// The shell line that makes a film of these frames (increasing, not empty), to be played at `fps` frames of
/// the shot a second. The film is named after the folder.
std::string ffmpeg_line(const PictureSequence& sequence, std::span<const int> frames, double fps);

}  // namespace flexkey
