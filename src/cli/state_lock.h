#pragma once

#include <filesystem>
#include <string>

#include "flexkey/animate/descriptor.h"

namespace flexkey::cli {

/// Keeps several flexkeys apart that work on one state: one may write, or several read. It ends with its
/// owner or the process.
class StateLock {
 public:
  enum class Holds { writing, reading, nothing };

  /// Locks a folder's file `lock` for writing, else, where others read or the file cannot be written, for
  /// reading.
  static StateLock for_writing(const std::filesystem::path& folder);
  /// Makes nothing where there is no such file.
  static StateLock for_reading(const std::filesystem::path& folder);

  Holds holds() const { return holds_; }
  /// Why it holds no more: "another flexkey solves this shot", or what the system says.
  const std::string& fault() const { return fault_; }

 private:
  Descriptor file_;
  Holds holds_ = Holds::nothing;
  std::string fault_;
};

}  // namespace flexkey::cli
