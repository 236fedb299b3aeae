#include "cli/output_paths.h"

#include <algorithm>
#include <system_error>

namespace flexkey::cli {
namespace {

namespace fs = std::filesystem;

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::weakly_canonical(a, ignored) == fs::weakly_canonical(b, ignored) ||
         fs::equivalent(a, b, ignored);
}

}  // namespace

bool is_special(const fs::path& path) {
  std::error_code ignored;
  return fs::is_other(path, ignored) || fs::is_character_file(path, ignored) || fs::is_fifo(path, ignored);
}

bool replaces_input(const LoadedShot& loaded, const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return false;
  return std::any_of(loaded.inputs.begin(), loaded.inputs.end(),
                     [&](const fs::path& input) { return same_file(path, input); });
}

}  // namespace flexkey::cli
