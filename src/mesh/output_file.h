#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace flexkey {

/// A file that appears under its name only when it is whole: written without a name or beside it, synced,
/// then renamed over it. What is not committed is removed. Every failure is an OutputError that names the
/// file and the reason.
class OutputFile {
 public:
  /// Makes the missing folders of `path`.
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);
  /// Gives the file its name. Nothing may be written after.
  void commit();
  std::uintmax_t bytes_written() const { return bytes_written_; }

 private:
  std::filesystem::path name_beside() const;

  std::filesystem::path path_, temporary_;
  int descriptor_ = -1;
  bool is_nameless_ = false;
  std::uintmax_t bytes_written_ = 0;
};

}  // namespace flexkey
