#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/mesh_input.h"
#include "cli/options.h"
#include "flexkey/html/write_picker.h"
#include "flexkey/mesh/weld.h"

namespace flexkey::cli {

int run_pick(const PickOptions& options) {
  const std::filesystem::path mesh = options.mesh;
  const std::filesystem::path page =
      options.output.empty() ? mesh.stem().concat(".html") : std::filesystem::path(options.output);
  std::error_code ignored;
  if (std::filesystem::equivalent(mesh, page, ignored))
    throw UsageError(fmt::format("the page '{}' would replace the mesh", page.string()));
  const MeshInput input = read_mesh_input(mesh);
  if (input.file.mesh.face_count() == 0)
    throw InputError(fmt::format("{}: no faces in it: there is nothing to pick on", mesh.string()));
  write_picker(weld(input.file.mesh), mesh.filename().string(), page);
  if (!options.quiet) say("open it in a browser: click the mesh, copy the selection\n");
  print_result(fmt::format("{}\n", page.string()));
  return done;
}

}  // namespace flexkey::cli
