#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "flexkey/preview/images/tags.h"
#include "flexkey/preview/picture.h"

namespace flexkey {

/// Writes a picture in the format that the path's extension names. The same picture and tags give the same
/// bytes; the file appears when it is whole. Throws InputError for an unknown format or a size that no
/// file can have, OutputError if it cannot be written.
void write_picture(const Picture& picture, const std::filesystem::path& path, const PictureTags& tags = {});

/// A picture file of any kind that OpenImageIO reads, in linear light; grey becomes red, green and blue, and
/// alpha is dropped. Throws InputError if it cannot be read.
Picture read_picture(const std::filesystem::path& path);

/// What the file says of itself; nothing if there is no such file, or none of ours.
std::optional<PictureTags> read_tags(const std::filesystem::path& path);

/// Whether the file is a frame made from inputs with this hash, so that it need not be made again.
bool was_made_from(const std::filesystem::path& path, std::string_view inputs);

}  // namespace flexkey
