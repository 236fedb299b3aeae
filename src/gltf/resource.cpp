#include "flexkey/gltf/resource.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/read_file.h"

namespace flexkey {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDataScheme = "data:";

/// %20 and its like as the bytes that they stand for; a '%' without two digits after it stays.
std::string percent_decoded(std::string_view uri) {
  std::string text;
  for (std::size_t at = 0; at < uri.size(); ++at) {
    int byte = 0;
    const char* const digits = uri.data() + at + 1;
    if (uri[at] == '%' && at + 2 < uri.size() &&
        std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      text += static_cast<char>(byte);
      at += 2;
    } else {
      text += uri[at];
    }
  }
  return text;
}

std::vector<unsigned char> decode_data_uri(const std::string& uri) {
  constexpr std::string_view encoding = ";base64,";
  const std::size_t comma = uri.find(',');
  const std::size_t start = uri.find(encoding);
  if (start == std::string::npos || start + encoding.size() != comma + 1)
    throw InputError("its data URI is not in base64");
  // tinygltf knows few media types, and the bytes are the same for all of them.
  std::vector<unsigned char> decoded;
  std::string ignored;
  const std::string known = "data:application/octet-stream;base64," + uri.substr(comma + 1);
  if (!tinygltf::DecodeDataURI(&decoded, ignored, known, 0, false))
    throw InputError("its data URI holds nothing");
  return decoded;
}

/// Letters before a ':' name a scheme ("http:"), or a drive.
bool has_scheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  return colon != std::string_view::npos && uri.substr(0, colon).find('/') == std::string_view::npos;
}

}  // namespace

bool is_data_uri(const std::string& uri) {
  return uri.starts_with(kDataScheme);
}

Resource read_resource(const std::string& uri, const fs::path& folder) {
  if (is_data_uri(uri)) return {decode_data_uri(uri), {}};
  if (has_scheme(uri)) throw InputError("only files can be read");
  const fs::path relative = fs::path(percent_decoded(uri)).lexically_normal();
  const bool leaves = relative.is_absolute() || relative.empty() || *relative.begin() == "..";
  if (leaves) throw InputError("it does not lie in the folder of the glTF");
  const fs::path path = folder / relative;
  std::error_code ignored;  // what cannot be looked at is not there
  if (!fs::is_regular_file(path, ignored)) throw InputError("there is no such file");
  const std::string file = read_file(path);
  return {{file.begin(), file.end()}, path};
}

std::string image_type_of(std::span<const unsigned char> bytes) {
  const auto has = [&](std::size_t offset, std::string_view magic) {
    return bytes.size() >= offset + magic.size() &&
           std::equal(
               magic.begin(), magic.end(), bytes.begin() + static_cast<std::ptrdiff_t>(offset),
               [](char wanted, unsigned char found) { return static_cast<unsigned char>(wanted) == found; });
  };
  if (has(0, "\x89PNG\r\n\x1a\n")) return "image/png";
  if (has(0, "\xFF\xD8\xFF")) return "image/jpeg";
  if (has(0, "RIFF") && has(8, "WEBP")) return "image/webp";
  return has(0, "\xABKTX 20\xBB") ? "image/ktx2" : "";
}

}  // namespace flexkey
