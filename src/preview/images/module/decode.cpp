#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>

#include "flexkey/mesh/error.h"
#include "flexkey/preview/images/module/codec.h"
#include "flexkey/preview/images/srgb.h"

namespace flexkey {
namespace {

using namespace OIIO;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw InputError(fmt::format("cannot read the picture '{}': {}", path.string(), reason));
}

std::unique_ptr<ImageInput> open(const std::filesystem::path& path) {
  ImageSpec as_stored;
  as_stored.attribute("oiio:UnassociatedAlpha", 1);  // colours not multiplied by an alpha that is dropped
  std::unique_ptr<ImageInput> input = ImageInput::open(path.string(), &as_stored);
  if (!input) fail(path, geterror());
  return input;
}

Bytes file_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> chars{std::istreambuf_iterator<char>(file), {}};
  const std::span<const std::byte> bytes = std::as_bytes(std::span(chars));
  return {bytes.begin(), bytes.end()};
}

std::string description_of(ImageInput& input, const std::filesystem::path& path) {
  if (std::string_view(input.format_name()) == "webp") return flexkey::description_of(file_bytes(path));
  return input.spec().get_string_attribute("ImageDescription");
}

/// Red, green and blue of pixels with any number of channels: one or two are grey.
std::vector<float> rgb_of(const std::vector<float>& values, std::size_t channels) {
  std::vector<float> rgb(values.size() / channels * 3);
  const std::size_t green = channels < 3 ? 0 : 1, blue = channels < 3 ? 0 : 2;
  for (std::size_t i = 0, pixel = 0; i < rgb.size(); i += 3, pixel += channels) {
    rgb[i] = values[pixel];
    rgb[i + 1] = values[pixel + green];
    rgb[i + 2] = values[pixel + blue];
  }
  return rgb;
}

}  // namespace

DescribedPicture decode(const std::filesystem::path& path) {
  const std::unique_ptr<ImageInput> input = open(path);
  const ImageSpec spec = input->spec();
  try {
    check_picture_size(spec.width, spec.height);
  } catch (const InputError& error) {
    fail(path, error.what());
  }
  const auto channels = static_cast<std::size_t>(std::min(spec.nchannels, 4));
  std::vector<float> values(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
                            channels);
  if (!input->read_image(0, 0, 0, static_cast<int>(channels), TypeDesc::FLOAT, values.data()))
    fail(path, input->geterror());

  DescribedPicture result{{spec.width, spec.height, rgb_of(values, channels)}, description_of(*input, path)};
  if (spec.get_string_attribute("oiio:ColorSpace") != "Linear" && !spec.format.is_floating_point())
    std::transform(result.picture.rgb.begin(), result.picture.rgb.end(), result.picture.rgb.begin(),
                   linear_from_srgb);
  return result;
}

std::string read_description(const std::filesystem::path& path) {
  const std::unique_ptr<ImageInput> input = ImageInput::open(path.string());
  if (input) return description_of(*input, path);
  geterror();  // clears it; a file that is no picture has no description
  return {};
}

}  // namespace flexkey
