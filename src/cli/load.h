#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/options.h"
#include "cli/timeline_files.h"
#include "flexkey/animate/scene.h"
#include "flexkey/gltf/read_gltf.h"
#include "flexkey/mesh/mesh.h"
#include "flexkey/timeline/shot.h"

namespace flexkey::cli {

/// A timeline as read from disk, and the runs that it asks for.
struct ReadTimeline {
  std::string text;
  TimelineFiles files;
  std::vector<std::string> warnings;        // whole lines
  std::vector<Shot> runs;                   // one, or those of its sweep
  std::vector<std::vector<Shot>> families;  // that are to be solved: the same, or a chunk of them; those that
                                            // differ in λ alone are solved together
};

/// Runs of a shot that are solved together, and their mesh as read from disk.
struct LoadedShot {
  Shot shot;               // what they have in common: the first
  std::vector<Shot> runs;  // with the paths of their outputs
  Mesh mesh;
  std::optional<GltfSource> source;  // where the mesh is of a glTF file
  std::filesystem::path mesh_path;
  std::vector<std::filesystem::path> inputs;  // files that no output may replace
  std::vector<std::string> warnings;          // whole lines
  std::string hash;                           // of timeline, overrides, mesh and what it names, hexadecimal
};

/// Throws TimelineError, InputError, UsageError.
ReadTimeline read_shot(const ShotOptions& options);

/// Reads the mesh of a family. Throws TimelineError, InputError.
LoadedShot load_family(const ReadTimeline& timeline, std::size_t family, const ShotOptions& options);

/// Reads a timeline and the mesh of its first family.
LoadedShot load_shot(const ShotOptions& options);

/// Resolves the shot, or another made of it, on its mesh. Throws TimelineError, whose places may be in the
/// file or in a `--set`.
Scene bind_loaded(const Shot& shot, const LoadedShot& loaded, const ShotOptions& options);

/// The outputs' final paths, a run each; none where the shot names none. Throws TimelineError for what could
/// not be written after the solve: over an input, another file's name, more morph targets than are allowed.
std::vector<std::filesystem::path> plan_outputs(const LoadedShot& loaded, const ShotOptions& options,
                                                const std::vector<Shot>& runs);

/// XXH3 128-bit hash in hexadecimal: to tell whether inputs are the same, not to guard against forgery.
std::string hash_of(const std::vector<std::string>& parts);

}  // namespace flexkey::cli
