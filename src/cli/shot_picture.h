#pragma once

#include <filesystem>

#include "cli/load.h"
#include "flexkey/animate/scene.h"

namespace flexkey::cli {

/// Throws UsageError for a path that names no format of pictures, or a file that the shot reads.
void check_shot_picture(const LoadedShot& loaded, const std::filesystem::path& path);

/// Draws the mesh at rest as the shot sees it: handles blue, anchors red, the region of interest tinted,
/// where handles go green, and every handle's name. The camera is the shot's. Throws OutputError.
void write_shot_picture(const LoadedShot& loaded, const Scene& scene, const std::filesystem::path& path);

}  // namespace flexkey::cli
