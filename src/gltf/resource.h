#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace flexkey {

/// What a URI of a glTF file leads to.
struct Resource {
  std::vector<unsigned char> bytes;
  std::filesystem::path path;  // of the file; empty for a data URI
};

bool is_data_uri(const std::string& uri);

/// Reads a data URI in base64, or a file by its relative path; it must lie in `folder` or below it.
/// Throws InputError with the reason alone ("there is no such file").
Resource read_resource(const std::string& uri, const std::filesystem::path& folder);

/// "image/png", "image/jpeg", "image/webp" or "image/ktx2" by the image's first bytes; else empty.
std::string image_type_of(std::span<const unsigned char> bytes);

}  // namespace flexkey
