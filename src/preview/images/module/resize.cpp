#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <algorithm>

#include "flexkey/mesh/error.h"
#include "flexkey/preview/images/module/codec.h"

namespace flexkey {

Picture resize(const Picture& picture, int width, int height) {
  using namespace OIIO;
  std::vector<float> values = picture.rgb;
  const ImageBuf from(ImageSpec(picture.width, picture.height, 3, TypeDesc::FLOAT), values.data());
  Picture result{width, height,
                 std::vector<float>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3)};
  ImageBuf to(ImageSpec(width, height, 3, TypeDesc::FLOAT), result.rgb.data());
  if (!ImageBufAlgo::resize(to, from, "lanczos3"))
    throw OutputError(fmt::format("cannot resize a picture: {}", to.geterror()));
  // The filter swings a little below black beside bright edges.
  std::transform(result.rgb.begin(), result.rgb.end(), result.rgb.begin(),
                 [](float value) { return std::max(value, 0.0f); });
  return result;
}

}  // namespace flexkey
