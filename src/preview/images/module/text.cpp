#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include "flexkey/mesh/error.h"
#include "flexkey/preview/images/module/codec.h"

namespace flexkey {

Coverage text_coverage(const std::string& text, int size) {
  using namespace OIIO;
  constexpr const char* font = "DejaVuSans";
  const ROI box = ImageBufAlgo::text_size(text, size, font);
  if (!box.defined())
    throw OutputError(fmt::format(
        "cannot write text in pictures: no font {}; install the package fonts-dejavu-core", font));
  Coverage coverage{box.width(), box.height(), box.xbegin, box.ybegin, {}};
  coverage.share.resize(static_cast<std::size_t>(coverage.width) * static_cast<std::size_t>(coverage.height));
  ImageBuf drawn(ImageSpec(coverage.width, coverage.height, 1, TypeDesc::FLOAT), coverage.share.data());
  if (!ImageBufAlgo::render_text(drawn, -box.xbegin, -box.ybegin, text, size, font))
    throw OutputError(fmt::format("cannot write text in pictures: {}", drawn.geterror()));
  return coverage;
}

}  // namespace flexkey
