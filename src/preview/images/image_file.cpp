#include "flexkey/preview/images/image_file.h"

#include <system_error>

#include "flexkey/mesh/output_file.h"
#include "flexkey/preview/images/module.h"

namespace flexkey {
namespace {

/// The format that the extension names.
ImageFormat format_of(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  return image_format(extension.empty() ? extension : extension.substr(1));
}

}  // namespace

void write_picture(const Picture& picture, const std::filesystem::path& path, const PictureTags& tags) {
  const ImageFormat format = format_of(path);
  check_picture_size(picture.width, picture.height);
  OutputFile file(path);
  file.write(image_module().encode(picture, format, describe(tags)));
  file.commit();
}

Picture read_picture(const std::filesystem::path& path) {
  return image_module().decode(path).picture;
}

std::optional<PictureTags> read_tags(const std::filesystem::path& path) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown)) return {};
  return parse_tags(image_module().read_description(path));
}

bool was_made_from(const std::filesystem::path& path, std::string_view inputs) {
  const std::optional<PictureTags> tags = read_tags(path);
  return tags && tags->inputs == inputs;
}

}  // namespace flexkey
