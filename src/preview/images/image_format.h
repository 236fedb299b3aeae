#pragma once

#include <string>
#include <string_view>

namespace flexkey {

/// The formats of single pictures: png, webp and jpg are 8-bit sRGB, exr is linear in half floats.
enum class ImageFormat { png, exr, webp, jpg };

/// The format of this name ("png", "exr", "webp", "jpg" or "jpeg"). Throws InputError for any other.
ImageFormat image_format(std::string_view name);

/// Its name, which is also its files' extension without the dot.
std::string_view name_of(ImageFormat format);

/// Throws InputError where no picture of this size can be written: both at least 1, at most 16,384 a side
/// and 100 million pixels in all.
void check_picture_size(int width, int height);

}  // namespace flexkey
