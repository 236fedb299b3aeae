#pragma once

#include "flexkey/preview/images/module.h"

namespace flexkey {

// The functions of the module's table; see ImageModule.
Bytes encode(const Picture& picture, ImageFormat format, const std::string& description);
DescribedPicture decode(const std::filesystem::path& path);
std::string read_description(const std::filesystem::path& path);
Picture resize(const Picture& picture, int width, int height);
Coverage text_coverage(const std::string& text, int size);
void write_gif(const GifScreen& screen, const std::function<bool(GifFrame&)>& next,
               const std::function<void(std::span<const std::byte>)>& sink);

/// A WebP file with a description added as XMP, and the description of one; empty where there is none.
Bytes with_description(const Bytes& webp, const std::string& description);
std::string description_of(const Bytes& webp);

}  // namespace flexkey
