#include "cli/load.h"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <system_error>

#include "cli/mesh_input.h"
#include "cli/output_paths.h"
#include "cli/sweep_runs.h"
#include "flexkey/gltf/read_gltf.h"
#include "flexkey/mesh/defects.h"
#include "flexkey/mesh/read_file.h"
#include "flexkey/mesh/spelling.h"
#include "flexkey/mesh/weld.h"
#include "flexkey/timeline/parse.h"

namespace flexkey::cli {
namespace {

namespace fs = std::filesystem;

/// Where the paths that a timeline gives begin.
fs::path folder_of(const std::string& timeline) {
  return timeline == "-" ? fs::path() : fs::path(timeline).parent_path();
}

/// Reads the shot's mesh; a file or a node that is not there is blamed on the line that names it.
MeshInput read_named_mesh(const Shot& shot, const fs::path& path, const std::vector<Override>& overrides) {
  std::error_code ignored;
  const Mark where = shot.mesh.where;
  if (where.line > 0 && !fs::exists(path, ignored))
    throw InputError(fmt::format("{}:{}:{}: cannot read '{}': No such file or directory", shot.file,
                                 where.line, where.column, path.string()));
  std::vector<std::string> names;
  for (const NodeName& node : shot.mesh.nodes) names.push_back(node.name);
  try {
    return read_mesh_input(path, names);
  } catch (const UnknownNodeError& error) {
    throw TimelineError(shot.file, {error_at(shot.mesh.nodes[error.which()].where, error.what(), overrides)});
  }
}

int frames_to_write(const LoadedShot& loaded, const ShotOptions& options) {
  const std::vector<int> wanted = parse_frames(options.frames, loaded.shot.frame_count());
  return wanted.empty() ? loaded.shot.frame_count() : static_cast<int>(wanted.size());
}

/// What is wrong with writing a GLB there, or nothing.
std::string fault_of_output(const LoadedShot& loaded, const fs::path& path, const GltfOutput& output,
                            int frames) {
  if (lower_extension(path) != ".glb" && !is_special(path))
    return fmt::format("the output '{}' is a binary glTF and must end in '.glb'", path.string());
  if (replaces_input(loaded, path))
    return fmt::format("the output '{}' would replace an input; give it another name", path.string());
  const auto most_frames = output.max_targets - std::ssize(output.poses);
  if (output.basis == GltfOutput::Basis::frames && frames > most_frames)
    return fmt::format(
        "{} frames{} make as many morph targets, above max_targets, {}; write profile compat or web, lower "
        "fps, "
        "pick --frames, or set output.gltf.max_targets (many viewers stop at 256)",
        frames, output.poses.empty() ? "" : fmt::format(" and {} poses", output.poses.size()),
        output.max_targets);
  return {};
}

/// What is wrong with merging the weights into an animation of the mesh's file, or nothing.
std::string fault_of_merge(const LoadedShot& loaded, const Shot& run) {
  const std::string& name = run.gltf.merge_into.name;
  const std::string file = loaded.mesh_path.filename().string();
  if (name.empty()) return {};
  if (!loaded.source) return fmt::format("there is no animation '{}': {} is no glTF file", name, file);
  if (!run.clips.empty()) return "'merge_into' takes one animation, and 'clips' makes several";
  const std::vector<std::string>& known = loaded.source->animations;
  if (std::find(known.begin(), known.end(), name) != known.end()) return {};
  return no_such_name("animation", name, file, known);
}

}  // namespace

ReadTimeline read_shot(const ShotOptions& options) {
  ReadTimeline timeline{read_timeline(options.shot), {folder_of(options.shot), {}, {}}, {}, {}, {}};
  ParsedShot parsed =
      parse_shot(timeline.text, options.shot, options.overrides(), sources_of(timeline.files));
  for (const Diagnostic& warning : parsed.warnings)
    timeline.warnings.push_back(format_diagnostic(options.shot, warning));
  if (options.chunk && parsed.shot.swept.empty())
    throw UsageError(fmt::format("{} has no 'sweep', which --chunk would take a part of", options.shot));
  timeline.runs = std::move(parsed.runs);
  timeline.families =
      families_of(options.chunk ? runs_of_chunk(*options.chunk, timeline.runs) : timeline.runs);
  return timeline;
}

LoadedShot load_family(const ReadTimeline& timeline, std::size_t family, const ShotOptions& options) {
  LoadedShot loaded;
  loaded.runs = timeline.families[family];
  loaded.shot = loaded.runs.front();
  loaded.warnings = timeline.warnings;
  const TimelineFiles& files = timeline.files;
  loaded.mesh_path = files.folder / loaded.shot.mesh.file;
  MeshInput named = read_named_mesh(loaded.shot, loaded.mesh_path, options.overrides());
  MeshFile& file = named.file;
  loaded.mesh = std::move(file.mesh);
  loaded.source = std::move(named.source);
  for (const std::string& warning : file.warnings) loaded.warnings.push_back("warning: " + warning);
  for (const std::string& line : describe(find_defects(weld(loaded.mesh).surface)))
    loaded.warnings.push_back(fmt::format("warning: {}: {}", loaded.mesh_path.string(), line));

  std::vector<std::string> hashed{timeline.text, read_file(loaded.mesh_path)};
  for (const fs::path& input : file.inputs) hashed.push_back(read_file(input));
  hashed.insert(hashed.end(), files.contents.begin(), files.contents.end());
  hashed.insert(hashed.end(), options.set.begin(), options.set.end());
  loaded.hash = hash_of(hashed);

  loaded.inputs = std::move(file.inputs);
  loaded.inputs.insert(loaded.inputs.end(), files.paths.begin(), files.paths.end());
  loaded.inputs.emplace_back(options.shot == "-" ? "/dev/stdin" : options.shot);
  loaded.inputs.push_back(loaded.mesh_path);
  for (const Material& material : loaded.mesh.materials)
    if (!material.texture.empty()) loaded.inputs.push_back(loaded.mesh_path.parent_path() / material.texture);
  return loaded;
}

LoadedShot load_shot(const ShotOptions& options) {
  return load_family(read_shot(options), 0, options);
}

Scene bind_loaded(const Shot& shot, const LoadedShot& loaded, const ShotOptions& options) {
  try {
    return bind_shot(shot, loaded.mesh);
  } catch (const TimelineError& error) {
    std::vector<Diagnostic> diagnostics;
    for (const Diagnostic& found : error.diagnostics())
      diagnostics.push_back(error_at(found.where, found.message, options.overrides()));
    throw TimelineError(error.file(), std::move(diagnostics));
  }
}

std::vector<fs::path> plan_outputs(const LoadedShot& loaded, const ShotOptions& options,
                                   const std::vector<Shot>& runs) {
  std::vector<fs::path> paths;
  for (const Shot& run : runs) {
    if (run.gltf.path.empty()) continue;
    const fs::path path = options.out_dir / run.gltf.path;  // an absolute path stays as it is
    const std::string wrong = fault_of_output(loaded, path, run.gltf, frames_to_write(loaded, options));
    if (!wrong.empty())
      throw TimelineError(loaded.shot.file, {error_at(run.gltf.where, wrong, options.overrides())});
    if (const std::string unmerged = fault_of_merge(loaded, run); !unmerged.empty())
      throw TimelineError(loaded.shot.file,
                          {error_at(run.gltf.merge_into.where, unmerged, options.overrides())});
    paths.push_back(path);
  }
  return paths;
}

std::string hash_of(const std::vector<std::string>& parts) {
  std::string joined;  // each part behind its length, so that no two lists join to the same text
  for (const std::string& part : parts) joined += fmt::format("{}:", part.size()) + part;
  const XXH128_hash_t hash = XXH3_128bits(joined.data(), joined.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace flexkey::cli
