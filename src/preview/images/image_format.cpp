#include "flexkey/preview/images/image_format.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/limits.h"

namespace flexkey {
namespace {

constexpr std::array<std::string_view, 4> names{"png", "exr", "webp", "jpg"};  // in the order of ImageFormat

}  // namespace

ImageFormat image_format(std::string_view name) {
  if (name == "jpeg") return ImageFormat::jpg;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return static_cast<ImageFormat>(i);
  throw InputError(fmt::format("unknown picture format '{}'; use png, exr, webp or jpg", name));
}

std::string_view name_of(ImageFormat format) {
  return names[static_cast<std::size_t>(format)];
}

void check_picture_size(int width, int height) {
  if (width < 1 || height < 1)
    throw InputError(fmt::format("a picture of {} x {} pixels is empty", width, height));
  if (width > limits::picture_side || height > limits::picture_side ||
      std::int64_t{width} * height > limits::picture_pixels)
    throw InputError(fmt::format("a picture of {} x {} pixels is too large; at most {} a side and {} million",
                                 width, height, limits::picture_side, limits::picture_pixels / 1'000'000));
}

}  // namespace flexkey
