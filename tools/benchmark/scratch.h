#pragma once

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "flexkey/mesh/error.h"

namespace flexkey::bench {

/// A folder that is removed with the object.
class Scratch {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "flexkey-bench-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw Error("bench: no temporary folder");
    path_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace flexkey::bench
