#include "flexkey/mesh/read_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

/// At most one byte more than `most`, so that an endless stream ends.
void append_all(std::istream& stream, std::uintmax_t most, std::string& bytes) {
  std::array<char, 1 << 16> block;
  while (stream && bytes.size() <= most) {
    const std::uintmax_t wanted = std::min<std::uintmax_t>(block.size(), most + 1 - bytes.size());
    stream.read(block.data(), static_cast<std::streamsize>(wanted));
    bytes.append(block.data(), static_cast<std::size_t>(stream.gcount()));
  }
}

}  // namespace

std::string read_file(const std::filesystem::path& path, std::uintmax_t most) {
  const auto fail = [&](std::string_view reason) {
    throw InputError(fmt::format("cannot read '{}': {}", path.string(), reason));
  };
  // Opening a folder succeeds on Linux and only reading it fails.
  std::error_code ignored;  // what cannot be looked at cannot be opened either
  if (std::filesystem::is_directory(path, ignored)) fail(std::strerror(EISDIR));
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail(std::strerror(errno));
  const std::uintmax_t size = std::filesystem::file_size(path, ignored);  // of a pipe or a device: no number
  std::string bytes;
  if (!ignored && size <= most) bytes.reserve(size);
  if (ignored || size <= most) append_all(stream, most, bytes);
  if (stream.bad()) fail(std::strerror(errno));
  if ((!ignored && size > most) || bytes.size() > most) fail(fmt::format("it is larger than {} bytes", most));
  return bytes;
}

}  // namespace flexkey
