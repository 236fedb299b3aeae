#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace flexkey {

/// Blocks of bytes of one length, kept on disk rather than in memory, in a file without a name: nothing of it
/// is left behind, however the program ends. Every failure is an OutputError.
class Spool {
 public:
  /// In the folder of `beside`, which is made if it is missing.
  Spool(const std::filesystem::path& beside, std::size_t block_length);
  ~Spool();
  Spool(const Spool&) = delete;
  Spool& operator=(const Spool&) = delete;

  void add(const std::vector<std::uint8_t>& block);
  std::vector<std::uint8_t> block(std::size_t index) const;
  std::size_t size() const { return blocks_; }

 private:
  std::filesystem::path beside_;
  std::size_t block_length_;
  std::size_t blocks_ = 0;
  int descriptor_ = -1;
};

}  // namespace flexkey
