#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "flexkey/mesh/limits.h"

namespace flexkey {

/// A whole file's bytes. Throws InputError if there is no such file, it cannot be read, or is larger than
/// `most` bytes, of which no more are read.
std::string read_file(const std::filesystem::path& path, std::uintmax_t most = limits::file_bytes);

}  // namespace flexkey
