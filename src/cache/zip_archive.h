#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace flexkey {

/// A file within an archive; its bytes are somebody else's.
struct ZipEntry {
  std::string name;
  std::string_view bytes;
};

/// Writes a ZIP archive, nothing compressed, every file dated 1980-01-01 so that the same entries give the
/// same bytes. Returns the archive's size. Throws OutputError.
std::uintmax_t write_zip(const std::filesystem::path& path, const std::vector<ZipEntry>& entries);

}  // namespace flexkey
