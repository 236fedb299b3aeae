#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/mesh_input.h"
#include "cli/options.h"
#include "cli/starter.h"
#include "cli/starter_text.h"
#include "flexkey/animate/scene.h"
#include "flexkey/mesh/output_file.h"
#include "flexkey/mesh/weld.h"
#include "flexkey/timeline/parse.h"

namespace flexkey::cli {
namespace {

namespace fs = std::filesystem;

/// The mesh as a timeline in another folder names it.
std::string mesh_from(const fs::path& mesh, const fs::path& shot) {
  if (mesh.is_absolute() || !shot.has_parent_path()) return mesh.string();
  return fs::proximate(fs::absolute(mesh), fs::absolute(shot).parent_path()).string();
}

/// The name of the outputs; the GLB may not be the mesh.
std::string stem_of(const fs::path& mesh, const fs::path& shot) {
  const std::string stem = shot.stem().string();
  return mesh.filename() == stem + ".glb" ? stem + "_moving" : stem;
}

void refuse_to_replace(const InitOptions& options, const fs::path& shot) {
  std::error_code ignored;
  if (fs::equivalent(options.mesh, shot, ignored))
    throw UsageError(fmt::format("the timeline '{}' would replace the mesh", shot.string()));
  if (!options.force && fs::exists(fs::symlink_status(shot, ignored)))
    throw UsageError(fmt::format("'{}' is there already; --force replaces it", shot.string()));
}

/// Throws InputError where the timeline would not run: a name in the mesh that no timeline can write.
void require_that_it_runs(const std::string& text, const std::string& file, const Mesh& mesh) {
  try {
    bind_shot(parse_shot(text, file).shot, mesh);
  } catch (const TimelineError& error) {
    throw InputError(fmt::format("cannot write a timeline of this mesh: {}",
                                 format_diagnostic(error.file(), error.diagnostics().front())));
  }
}

void describe(const Starter& starter, const fs::path& shot) {
  std::string text = fmt::format("holds {}", starter.base.name);
  for (const StarterTip& tip : starter.tips) text += fmt::format(", swings {}", tip.part.name);
  say(fmt::format("{}; now: flexkey animate {} -d out\n", text, shot.string()));
}

}  // namespace

int run_init(const InitOptions& options) {
  const fs::path mesh_path = options.mesh;
  const bool prints = options.shot == "-";
  const fs::path shot =
      options.shot.empty() || prints ? mesh_path.stem().concat(".yaml") : fs::path(options.shot);
  if (!prints) refuse_to_replace(options, shot);
  const MeshInput input = read_mesh_input(mesh_path);
  const Weld surface = weld(input.file.mesh);
  const Starter starter = propose_starter(surface, mesh_path.filename().string());
  const StarterFiles files{mesh_from(mesh_path, shot), shot.string(), stem_of(mesh_path, shot)};
  const std::string text = starter_text(starter, surface, files);
  require_that_it_runs(text, shot.string(), input.file.mesh);
  if (prints) {
    print_result(text);
    return done;
  }
  OutputFile file(shot);
  file.write(text);
  file.commit();
  if (!options.quiet) describe(starter, shot);
  print_result(fmt::format("{}\n", shot.string()));
  return done;
}

}  // namespace flexkey::cli
