#include "flexkey/mesh/read_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "flexkey/mesh/error.h"

namespace flexkey {

std::string read_file(const std::filesystem::path& path) {
  const auto fail = [&](const char* reason) {
    throw InputError(fmt::format("cannot read '{}': {}", path.string(), reason));
  };
  // Opening a folder succeeds on Linux and only reading it fails.
  std::error_code ignored;  // what cannot be looked at cannot be opened either
  if (std::filesystem::is_directory(path, ignored)) fail(std::strerror(EISDIR));
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail(std::strerror(errno));
  std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (stream.bad()) fail(std::strerror(errno));
  return bytes;
}

}  // namespace flexkey
