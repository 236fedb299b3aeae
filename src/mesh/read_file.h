#pragma once

#include <filesystem>
#include <string>

namespace flexkey {

/// A whole file's bytes. Throws InputError if there is no such file or it cannot be read.
std::string read_file(const std::filesystem::path& path);

}  // namespace flexkey
