#pragma once

#include "cli/options.h"

namespace flexkey::cli {

/// `flexkey animate`: solves the shot and writes what it names. Returns an ExitCode.
int run_animate(const ShotOptions& options);

/// `flexkey sweep`: the same for every run of the shot's sweep, or a chunk of them. Returns an ExitCode.
int run_sweep(const ShotOptions& options);

/// `flexkey solve`: solves the shot into its state. Returns an ExitCode.
int run_solve(const ShotOptions& options);

/// `flexkey export`: writes the files that the shot names, from its state. Returns an ExitCode.
int run_export(const ShotOptions& options);

/// `flexkey render`: draws the pictures of the shot, from its state. Returns an ExitCode.
int run_render(const ShotOptions& options);

/// `flexkey check`: parses, loads, resolves every selection, prints a summary. Returns an ExitCode.
int run_check(const ShotOptions& options);

/// `flexkey watch`: makes what the shot names, drafts of its pictures first, and again whenever the timeline
/// or a file that it names changes, until a signal ends it. Returns 128 plus the signal.
int run_watch(const ShotOptions& options);

/// `flexkey schema`: prints the JSON Schema of timelines. Returns an ExitCode.
int run_schema();

struct InspectOptions {
  std::string mesh;  // a path
  bool json = false;
};

/// `flexkey inspect`: counts, bounds, parts and defects of a mesh. Returns an ExitCode.
int run_inspect(const InspectOptions& options);

struct PickOptions {
  std::string mesh;    // a path
  std::string output;  // the page; empty: by the mesh's name
  bool quiet = false;
};

/// `flexkey pick`: writes a page on which selections are picked. Returns an ExitCode.
int run_pick(const PickOptions& options);

struct InitOptions {
  std::string mesh;    // a path
  std::string shot;    // where the timeline goes, "-" for standard output; empty: by the mesh's name
  bool force = false;  // replace what is there
  bool quiet = false;
};

/// `flexkey init`: writes a first timeline for a mesh. Returns an ExitCode.
int run_init(const InitOptions& options);

struct CompletionOptions {
  std::string shell;  // "bash", "zsh" or "fish"
};

/// `flexkey completion`: prints the script with which a shell completes. Returns an ExitCode.
int run_completion(const CompletionOptions& options);

/// `flexkey man`: prints the man page. Returns an ExitCode.
int run_man();

}  // namespace flexkey::cli
