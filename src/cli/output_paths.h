#pragma once

#include <filesystem>

#include "cli/load.h"

namespace flexkey::cli {

/// A device or a pipe is written as it is; only a file has a name that tells its format.
bool is_special(const std::filesystem::path& path);

/// Whether a file that is written there would replace one that the shot reads.
bool replaces_input(const LoadedShot& loaded, const std::filesystem::path& path);

}  // namespace flexkey::cli
