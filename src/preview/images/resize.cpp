#include "flexkey/preview/images/resize.h"

#include <algorithm>
#include <cmath>

#include "flexkey/preview/images/module.h"

namespace flexkey {

Picture resized(const Picture& picture, int width, int height) {
  check_picture_size(picture.width, picture.height);
  check_picture_size(width, height);
  if (width == picture.width && height == picture.height) return picture;
  return image_module().resize(picture, width, height);
}

Picture resized_to_width(const Picture& picture, int width) {
  check_picture_size(picture.width, picture.height);
  const auto height = std::lround(static_cast<double>(picture.height) * width / picture.width);
  return resized(picture, width, std::max(1, static_cast<int>(height)));
}

}  // namespace flexkey
