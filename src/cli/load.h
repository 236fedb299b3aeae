#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/options.h"
#include "flexkey/animate/scene.h"
#include "flexkey/mesh/mesh.h"
#include "flexkey/timeline/shot.h"

namespace flexkey::cli {

/// A shot and its mesh as read from disk.
struct LoadedShot {
  Shot shot;
  Mesh mesh;
  std::filesystem::path mesh_path;
  std::vector<std::filesystem::path> inputs;  // files that no output may replace
  std::vector<std::string> warnings;          // whole lines
  std::string hash;                           // of timeline, overrides and mesh, hexadecimal
};

/// Reads timeline and mesh. Throws TimelineError, InputError, UsageError.
LoadedShot load_shot(const ShotOptions& options);

/// Resolves the shot on its mesh. Throws TimelineError, whose places may be in the file or in a `--set`.
Scene bind_loaded(const LoadedShot& loaded, const ShotOptions& options);

/// Where an output path of a shot goes. Throws UsageError if that is one of the inputs.
std::filesystem::path output_path(const LoadedShot& loaded, const ShotOptions& options,
                                  const std::string& path);

/// XXH3 128-bit hash in hexadecimal: to tell whether inputs are the same, not to guard against forgery.
std::string hash_of(const std::vector<std::string>& parts);

}  // namespace flexkey::cli
