#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <memory>

#include "flexkey/mesh/error.h"
#include "flexkey/preview/images/module/codec.h"
#include "flexkey/preview/images/srgb.h"

namespace flexkey {
namespace {

using namespace OIIO;

ImageSpec spec_of(const Picture& picture, ImageFormat format, const std::string& description) {
  const bool linear = format == ImageFormat::exr;
  ImageSpec spec(picture.width, picture.height, 3, linear ? TypeDesc::HALF : TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
  spec.attribute("Software", "flexkey " FLEXKEY_VERSION);
  if (format != ImageFormat::webp) spec.attribute("ImageDescription", description);
  if (format == ImageFormat::exr)
    spec.attribute("DateTime", "1970:01:01 00:00:00");  // else the time of writing
  if (format == ImageFormat::png)
    spec.attribute("png:filter", 0x10);  // each pixel from its left one packs best
  if (format == ImageFormat::webp) spec.attribute("Compression", "webp:90");
  if (format == ImageFormat::jpg) {
    spec.attribute("Compression", "jpeg:92");
    spec.attribute("jpeg:subsampling", "4:4:4");  // thin coloured lines stay sharp
  }
  return spec;
}

}  // namespace

Bytes encode(const Picture& picture, ImageFormat format, const std::string& description) {
  const std::string name = fmt::format("picture.{}", name_of(format));
  const auto fail = [&](const std::string& reason) {
    throw OutputError(fmt::format("cannot make a {} picture: {}", name_of(format), reason));
  };
  std::vector<unsigned char> file;
  Filesystem::IOVecOutput memory(file);
  const std::unique_ptr<ImageOutput> output = ImageOutput::create(name);
  if (!output) fail(geterror());
  if (!output->set_ioproxy(&memory)) fail("OpenImageIO cannot write it to memory");
  if (!output->open(name, spec_of(picture, format, description))) fail(output->geterror());
  const bool written = format == ImageFormat::exr
                           ? output->write_image(TypeDesc::FLOAT, picture.rgb.data())
                           : output->write_image(TypeDesc::UINT8, srgb_bytes(picture).data());
  if (!written || !output->close()) fail(output->geterror());

  const std::span<const std::byte> bytes = std::as_bytes(std::span(file));
  const Bytes result(bytes.begin(), bytes.end());
  return format == ImageFormat::webp ? with_description(result, description) : result;
}

}  // namespace flexkey
