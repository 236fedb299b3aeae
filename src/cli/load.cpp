#include "cli/load.h"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <iterator>
#include <system_error>

#include "flexkey/mesh/defects.h"
#include "flexkey/mesh/read_file.h"
#include "flexkey/mesh/read_mesh.h"
#include "flexkey/mesh/weld.h"
#include "flexkey/timeline/parse.h"

namespace flexkey::cli {
namespace {

namespace fs = std::filesystem;

fs::path mesh_path_of(const Shot& shot) {
  const fs::path folder = shot.file == "-" ? fs::path() : fs::path(shot.file).parent_path();
  return folder / shot.mesh.file;
}

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code ignored;  // a file that is not there is the same as no other
  return fs::weakly_canonical(a, ignored) == fs::weakly_canonical(b, ignored) ||
         fs::equivalent(a, b, ignored);
}

}  // namespace

LoadedShot load_shot(const ShotOptions& options) {
  LoadedShot loaded;
  const std::vector<Override> overrides = options.overrides();
  const std::string text = read_timeline(options.shot);
  ParsedShot parsed = parse_shot(text, options.shot, overrides);
  loaded.shot = std::move(parsed.shot);
  for (const Diagnostic& warning : parsed.warnings)
    loaded.warnings.push_back(format_diagnostic(loaded.shot.file, warning));

  loaded.mesh_path = mesh_path_of(loaded.shot);
  MeshFile file = read_mesh(loaded.mesh_path);
  loaded.mesh = std::move(file.mesh);
  for (const std::string& warning : file.warnings) loaded.warnings.push_back("warning: " + warning);
  for (const std::string& line : describe(find_defects(weld(loaded.mesh).surface)))
    loaded.warnings.push_back(fmt::format("warning: {}: {}", loaded.mesh_path.string(), line));

  if (options.shot != "-") loaded.inputs.emplace_back(options.shot);
  loaded.inputs.push_back(loaded.mesh_path);
  std::vector<std::string> hashed{text, read_file(loaded.mesh_path)};
  hashed.insert(hashed.end(), options.set.begin(), options.set.end());
  loaded.hash = hash_of(hashed);
  return loaded;
}

Scene bind_loaded(const LoadedShot& loaded, const ShotOptions& options) {
  try {
    return bind_shot(loaded.shot, loaded.mesh);
  } catch (const TimelineError& error) {
    std::vector<Diagnostic> diagnostics;
    for (const Diagnostic& found : error.diagnostics())
      diagnostics.push_back(error_at(found.where, found.message, options.overrides()));
    throw TimelineError(error.file(), std::move(diagnostics));
  }
}

fs::path output_path(const LoadedShot& loaded, const ShotOptions& options, const std::string& path) {
  const fs::path result = options.out_dir / path;  // an absolute path stays as it is
  for (const fs::path& input : loaded.inputs)
    if (same_file(result, input))
      throw UsageError(
          fmt::format("the output '{}' would replace an input; give it another name", result.string()));
  return result;
}

std::string hash_of(const std::vector<std::string>& parts) {
  std::string joined;  // each part behind its length, so that no two lists join to the same text
  for (const std::string& part : parts) joined += fmt::format("{}:", part.size()) + part;
  const XXH128_hash_t hash = XXH3_128bits(joined.data(), joined.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace flexkey::cli
