#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/guarded.h"
#include "cli/interrupt.h"
#include "flexkey/mesh/spelling.h"

namespace {

using namespace flexkey;
using namespace flexkey::cli;

constexpr const char* exit_codes = R"(Exit codes:
  0 done   1 internal fault   2 usage or timeline error   3 bad mesh or other input
  4 did not converge (--strict)   5 an output could not be written   130, 143 stopped by a signal)";

void add_shot_options(CLI::App& command, ShotOptions& options) {
  command.add_option("shot", options.shot, "Timeline file, or - for standard input")
      ->required()
      ->type_name("SHOT.yaml");
  command.add_option("--set", options.set, "Override a key of the timeline; may be repeated")
      ->type_name("key.path=value")
      ->expected(1)
      ->take_all()
      ->trigger_on_parse(false);
  command
      .add_option("-d,--out-dir", options.out_dir, "Folder that outputs go to; made if missing (default: .)")
      ->type_name("DIR");
  command.add_flag("--json", options.json, "Print a machine-readable report on standard output");
  command.add_flag("-q,--quiet", options.quiet, "Print errors only");
}

void add_run_options(CLI::App& command, ShotOptions& options) {
  command
      .add_option("--frames", options.frames, "Write these frames only; the solve still starts at frame 0")
      ->type_name("0-30,47,60-90x2");
  command
      .add_option("--threads", options.threads, "Threads to use (default: SLURM_CPUS_PER_TASK or every core)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command.add_flag("--strict", options.strict, "Exit 4 if a frame did not converge");
}

/// What is wrong with the command's name, or nothing; flags and no name at all are left to CLI11.
std::string unknown_command(int argc, char** argv) {
  const std::vector<std::string> built{"animate", "sweep",   "solve", "export", "render", "check",
                                       "watch",   "inspect", "init",  "pick",   "schema"};
  if (argc < 2 || argv[1][0] == '-') return {};
  const std::string name = argv[1];
  if (std::find(built.begin(), built.end(), name) != built.end()) return {};
  return fmt::format("unknown command '{}'{}", name, did_you_mean(name, built));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("flexkey turns a text timeline into an animated mesh.", "flexkey");
  app.set_version_flag("--version", "flexkey " FLEXKEY_VERSION);
  app.require_subcommand(1);
  app.footer(exit_codes);

  ShotOptions options;
  CLI::App* animate = app.add_subcommand("animate", "Solve a shot and write every output that it names");
  add_shot_options(*animate, options);
  add_run_options(*animate, options);
  animate->footer("Example:\n  flexkey animate timelines/nose.yaml -d out\n");

  std::string chunk, part;
  CLI::App* sweep =
      app.add_subcommand("sweep", "Solve and write every run of a shot's sweep, or a part of them");
  add_shot_options(*sweep, options);
  add_run_options(*sweep, options);
  sweep->add_option("--chunk", chunk, "The i-th of n parts of the runs, for several machines")
      ->type_name("i/n");
  sweep->footer("Example:\n  flexkey sweep shot.yaml --chunk 2/4 -d out\n");

  CLI::App* solve = app.add_subcommand(
      "solve", "Solve a shot into its state, DIR/.flexkey/SHOT/; run again, it goes on where it stopped");
  add_shot_options(*solve, options);
  add_run_options(*solve, options);
  solve->footer("Example:\n  flexkey solve timelines/nose.yaml -d out\n");

  CLI::App* write = app.add_subcommand(
      "export", "Write the files that a shot names from its state; solve what is missing or stale first");
  add_shot_options(*write, options);
  add_run_options(*write, options);
  write->add_flag("--no-solve", options.no_solve, "Exit 2 instead where the state is missing or stale");
  write->footer("Example:\n  flexkey export timelines/nose.yaml -d out --no-solve\n");

  CLI::App* render = app.add_subcommand(
      "render", "Draw a shot's pictures from its state; solve what is missing or stale first");
  add_shot_options(*render, options);
  add_run_options(*render, options);
  render->add_flag("--no-solve", options.no_solve, "Exit 2 instead where the state is missing or stale");
  render
      ->add_option("--chunk", part,
                   "The i-th of n parts of the frames, for several machines: no GIF, no sheet")
      ->type_name("i/n");
  render->footer("Example:\n  flexkey render timelines/leg.yaml --frames 0,24 -d out\n");

  CLI::App* check =
      app.add_subcommand("check", "Parse a shot, load its mesh, resolve every selection; solve nothing");
  add_shot_options(*check, options);
  check
      ->add_option("--picture", options.picture,
                   "Draw the mesh with its handles, anchors, region and paths, each handle named")
      ->type_name("FILE");
  check->footer("Example:\n  flexkey check timelines/jaw.yaml --picture out/jaw.png\n");

  CLI::App* watch = app.add_subcommand(
      "watch", "Check, solve, draw and write a shot whenever one of its files is saved; Ctrl-C ends it");
  add_shot_options(*watch, options);
  add_run_options(*watch, options);
  watch->footer("Example:\n  flexkey watch timelines/nose.yaml -d out\n");

  InspectOptions inspect_options;
  CLI::App* inspect =
      app.add_subcommand("inspect", "Print a mesh's counts, bounds, groups, components, borders and defects");
  inspect->add_option("mesh", inspect_options.mesh, "Mesh file: OBJ, PLY, OFF, STL, GLB or glTF")
      ->required()
      ->type_name("MESH");
  inspect->add_flag("--json", inspect_options.json, "Print them as JSON");
  inspect->footer("Example:\n  flexkey inspect timelines/meshes/pig.obj\n");

  InitOptions init_options;
  CLI::App* init =
      app.add_subcommand("init", "Write a first timeline for a mesh, with comments, that runs as it is");
  init->add_option("mesh", init_options.mesh, "Mesh file: OBJ, GLB or glTF")->required()->type_name("MESH");
  init->add_option("shot", init_options.shot,
                   "Timeline to write, or - for standard output (default: MESH's name)")
      ->type_name("SHOT.yaml");
  init->add_flag("--force", init_options.force, "Replace a timeline that is there");
  init->add_flag("-q,--quiet", init_options.quiet, "Print errors only");
  init->footer("Example:\n  flexkey init cow.obj shot.yaml && flexkey animate shot.yaml -d out\n");

  PickOptions pick_options;
  CLI::App* pick =
      app.add_subcommand("pick", "Write a page on which a click or a brush gives a selection to paste");
  pick->add_option("mesh", pick_options.mesh, "Mesh file: OBJ, GLB or glTF")->required()->type_name("MESH");
  pick->add_option("-o", pick_options.output, "Page to write (default: MESH's name)")->type_name("PAGE.html");
  pick->add_flag("-q,--quiet", pick_options.quiet, "Print errors only");
  pick->footer("Example:\n  flexkey pick cow.obj -o pick.html\n");

  CLI::App* schema = app.add_subcommand("schema", "Print the JSON Schema of timelines, for editors");
  schema->footer("Example:\n  flexkey schema > timeline.schema.json\n");

  report_failed_writes();
  if (const std::string unknown = unknown_command(argc, argv); !unknown.empty()) {
    say(fmt::format("flexkey: error: {}\n", unknown));
    return bad_timeline;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (app.exit(error) != 0) return bad_timeline;
    return std::cout.flush() ? done : unwritten;
  }
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(thread_count(options.threads)));
  if (animate->parsed()) return guarded([&] { return run_animate(options); });
  if (sweep->parsed())
    return guarded([&] {
      if (!chunk.empty()) options.chunk = parse_chunk(chunk);
      return run_sweep(options);
    });
  if (solve->parsed()) return guarded([&] { return run_solve(options); });
  if (write->parsed()) return guarded([&] { return run_export(options); });
  if (render->parsed())
    return guarded([&] {
      if (!part.empty()) options.part = parse_chunk(part);
      return run_render(options);
    });
  if (init->parsed()) return guarded([&] { return run_init(init_options); });
  if (watch->parsed()) return guarded([&] { return run_watch(options); });
  if (pick->parsed()) return guarded([&] { return run_pick(pick_options); });
  if (schema->parsed()) return guarded(run_schema);
  if (inspect->parsed()) return guarded([&] { return run_inspect(inspect_options); });
  return guarded([&] { return run_check(options); });
}
