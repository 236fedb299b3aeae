#include "cli/command_table.h"

namespace flexkey::cli {
namespace {

std::vector<Argument> operator+(std::vector<Argument> some, const std::vector<Argument>& more) {
  some.insert(some.end(), more.begin(), more.end());
  return some;
}

std::vector<Argument> shot_arguments(ShotOptions& options) {
  return {
      {.names = {"shot"},
       .value = "SHOT.yaml",
       .help = "Timeline file, or - for standard input",
       .target = &options.shot,
       .offer = Offer::timeline,
       .is_required = true},
      {{"--set"}, "key.path=value", "Override a key of the timeline; may be repeated", &options.set},
      {{"-d", "--out-dir"},
       "DIR",
       "Folder that outputs go to; made if missing (default: .)",
       &options.out_dir,
       Offer::folder},
      {{"--json"}, "", "Print a machine-readable report on standard output", &options.json},
      {{"-q", "--quiet"}, "", "Print errors only", &options.quiet},
  };
}

std::vector<Argument> run_arguments(ShotOptions& options) {
  return {
      {{"--frames"},
       "0-30,47,60-90x2",
       "Write these frames only; the solve still starts at frame 0",
       &options.frames},
      {{"--threads"}, "N", "Threads to use (default: SLURM_CPUS_PER_TASK or every core)", &options.threads},
      {{"--strict"}, "", "Exit 4 if a frame did not converge", &options.strict},
  };
}

Argument no_solve(ShotOptions& options) {
  return {{"--no-solve"}, "", "Exit 2 instead where the state is missing or stale", &options.no_solve};
}

Argument mesh_argument(std::string& mesh) {
  return {.names = {"mesh"},
          .value = "MESH",
          .help = "Mesh file: OBJ, PLY, OFF, STL, GLB or glTF",
          .target = &mesh,
          .offer = Offer::mesh,
          .is_required = true};
}

Argument chunk_option(std::string& chunk, std::string_view help) {
  return {{"--chunk"}, "i/n", help, &chunk};
}

std::vector<Command> commands_on_shots(Request& request) {
  ShotOptions& options = request.shot;
  const std::vector<Argument> shot = shot_arguments(options), run = run_arguments(options);
  return {
      {"animate", "Solve a shot and write every output that it names",
       "flexkey animate timelines/nose.yaml -d out", shot + run, [&] { return run_animate(options); }},
      {"sweep", "Solve and write every run of a shot's sweep, or a part of them",
       "flexkey sweep shot.yaml --chunk 2/4 -d out",
       shot + run +
           std::vector{chunk_option(request.chunk, "The i-th of n parts of the runs, for several machines")},
       [&] {
         if (!request.chunk.empty()) options.chunk = parse_chunk(request.chunk);
         return run_sweep(options);
       }},
      {"solve", "Solve a shot into its state, DIR/.flexkey/SHOT/; run again, it goes on where it stopped",
       "flexkey solve timelines/nose.yaml -d out", shot + run, [&] { return run_solve(options); }},
      {"export", "Write the files that a shot names from its state; solve what is missing or stale first",
       "flexkey export timelines/nose.yaml -d out --no-solve", shot + run + std::vector{no_solve(options)},
       [&] { return run_export(options); }},
      {"render", "Draw a shot's pictures from its state; solve what is missing or stale first",
       "flexkey render timelines/leg.yaml --frames 0,24 -d out",
       shot + run +
           std::vector{
               no_solve(options),
               chunk_option(request.chunk,
                            "The i-th of n parts of the frames, for several machines: no GIF, no sheet")},
       [&] {
         if (!request.chunk.empty()) options.part = parse_chunk(request.chunk);
         return run_render(options);
       }},
      {"check", "Parse a shot, load its mesh, resolve every selection; solve nothing",
       "flexkey check timelines/jaw.yaml --picture out/jaw.png",
       shot + std::vector<Argument>{{{"--picture"},
                                     "FILE",
                                     "Draw the mesh with its handles, anchors, region and paths, each named",
                                     &options.picture,
                                     Offer::file}},
       [&] { return run_check(options); }},
      {"watch", "Check, solve, draw and write a shot whenever one of its files is saved; Ctrl-C ends it",
       "flexkey watch timelines/nose.yaml -d out", shot + run, [&] { return run_watch(options); }},
  };
}

Argument help_option() {
  return {{"-h", "--help"}, "", "Print this help message and exit", static_cast<bool*>(nullptr)};
}

Command inspect_command(InspectOptions& options) {
  return {"inspect",
          "Print a mesh's counts, bounds, groups, components, borders and defects",
          "flexkey inspect timelines/meshes/pig.obj",
          {mesh_argument(options.mesh), {{"--json"}, "", "Print them as JSON", &options.json}},
          [&] { return run_inspect(options); }};
}

Command init_command(InitOptions& options) {
  return {"init",
          "Write a first timeline for a mesh, with comments, that runs as it is",
          "flexkey init cow.obj shot.yaml && flexkey animate shot.yaml -d out",
          {mesh_argument(options.mesh),
           {{"shot"},
            "SHOT.yaml",
            "Timeline to write, or - for standard output (default: MESH's name)",
            &options.shot},
           {{"--force"}, "", "Replace a timeline that is there", &options.force},
           {{"-q", "--quiet"}, "", "Print errors only", &options.quiet}},
          [&] { return run_init(options); }};
}

Command pick_command(PickOptions& options) {
  return {"pick",
          "Write a page on which a click or a brush gives a selection to paste",
          "flexkey pick cow.obj -o pick.html",
          {mesh_argument(options.mesh),
           {{"-o"}, "PAGE.html", "Page to write (default: MESH's name)", &options.output, Offer::file},
           {{"-q", "--quiet"}, "", "Print errors only", &options.quiet}},
          [&] { return run_pick(options); }};
}

Command completion_command(CompletionOptions& options) {
  return {"completion",
          "Print the script with which a shell completes flexkey's commands, options and files",
          "source <(flexkey completion bash)",
          {{.names = {"shell"},
            .value = "SHELL",
            .help = "bash, zsh or fish",
            .target = &options.shell,
            .offer = Offer::words,
            .words = {"bash", "zsh", "fish"},
            .is_required = true}},
          [&] { return run_completion(options); }};
}

}  // namespace

std::vector<Command> command_table(Request& request) {
  std::vector<Command> table = commands_on_shots(request);
  table.push_back(inspect_command(request.inspect));
  table.push_back(init_command(request.init));
  table.push_back(pick_command(request.pick));
  table.push_back({"schema",
                   "Print the JSON Schema of timelines, for editors",
                   "flexkey schema > timeline.schema.json",
                   {},
                   run_schema});
  table.push_back(completion_command(request.completion));
  table.push_back({"man", "Print the man page, flexkey(1)", "flexkey man | man -l -", {}, run_man});
  for (Command& command : table) command.arguments.push_back(help_option());
  return table;
}

std::vector<Argument> program_options() {
  return {help_option(),
          {{"--version"}, "", "Display program version information and exit", static_cast<bool*>(nullptr)}};
}

std::vector<std::string_view> endings_of(Offer offer) {
  if (offer == Offer::timeline) return {"yaml", "yml"};
  if (offer == Offer::mesh) return {"obj", "ply", "off", "stl", "glb", "gltf"};
  return {};
}

const std::vector<ExitCodeText>& exit_code_texts() {
  static const std::vector<ExitCodeText> texts{
      {"0", "done"},
      {"1", "internal fault"},
      {"2", "usage or timeline error"},
      {"3", "bad mesh or other input"},
      {"4", "did not converge (--strict)"},
      {"5", "an output could not be written"},
      {"130, 143", "stopped by a signal"},
  };
  return texts;
}

}  // namespace flexkey::cli
