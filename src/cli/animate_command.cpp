#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <span>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/gltf_options.h"
#include "cli/interrupt.h"
#include "cli/load.h"
#include "cli/progress.h"
#include "cli/report.h"
#include "cli/stopwatch.h"
#include "flexkey/animate/animate.h"
#include "flexkey/gltf/write_glb.h"
#include "flexkey/mesh/output_file.h"
#include "flexkey/timeline/parse.h"

namespace flexkey::cli {
namespace {

/// Runs of a sweep that are solved in one pass; more would gain little and hold more clips in memory.
constexpr std::size_t together = 5;

/// Where the outputs go. Refuses, before hours of solving, what could not be written after.
std::vector<std::filesystem::path> require_outputs(const LoadedShot& loaded, const ShotOptions& options,
                                                   const std::vector<Shot>& runs) {
  std::vector<std::filesystem::path> paths = plan_outputs(loaded, options, runs);
  if (paths.empty())
    throw UsageError(
        fmt::format("{} names no output; add 'output: {}.glb'", loaded.shot.file, loaded.shot.name));
  for (const std::filesystem::path& path : paths)
    OutputFile probe(path);  // made and, uncommitted, removed again
  return paths;
}

struct Solved {
  Clip clip;
  RunReport report;
};

/// Solves runs of one sweep together.
std::vector<Solved> solve(const LoadedShot& loaded, std::span<const Shot> runs, const Scene& scene,
                          const std::vector<int>& wanted, Progress& progress) {
  std::vector<Solved> solved(runs.size());
  AnimateHooks hooks;
  hooks.on_frame = [&](std::size_t run, const FrameReport& frame) {
    solved[run].report.frames.push_back(frame);
    progress.advance();
  };
  hooks.stop = [] { return noted_signal() != 0; };
  std::vector<Take> takes;
  for (const Shot& run : runs) takes.push_back({run, scene});
  const Stopwatch watch;
  std::vector<Clip> clips = animate(takes, loaded.mesh, wanted, hooks);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    RunReport& report = solved[k].report;
    solved[k].clip = std::move(clips[k]);
    report.solve_seconds = watch.seconds() / static_cast<double>(runs.size());
    report.claims_convergence = runs[k].solver.preset != SolverSettings::Preset::paper;
    if (report.frames.empty()) continue;
    report.lambda_first = report.frames.front().lambda;
    report.lambda_last = report.frames.back().lambda;
  }
  return solved;
}

void write(Solved& solved, const Shot& run, const LoadedShot& loaded, const std::filesystem::path& path,
           Verbosity verbosity) {
  const Stopwatch watch;
  GltfOptions options = gltf_options(run, loaded);
  const int frames = static_cast<int>(solved.clip.frames.size());
  Progress progress(frames, verbosity, "Writing");
  options.on_progress = [&](double share) { progress.reach(static_cast<int>(share * frames)); };
  solved.report.written.push_back({path, write_glb(solved.clip, options, path)});
  solved.report.write_seconds = watch.seconds();
}

void print_report(const LoadedShot& loaded, const ShotOptions& options, const std::vector<RunReport>& reports,
                  double load_seconds) {
  if (!options.quiet) {
    for (const RunReport& report : reports)
      for (const WrittenFile& file : report.written)
        for (const std::string& warning : file.gltf.warnings) say(fmt::format("warning: {}\n", warning));
    say(report_text(loaded, reports, load_seconds));
  }
  if (options.json) {
    print_result(fmt::format("{}\n", report_json(loaded, reports, load_seconds)));
  } else if (!options.quiet) {
    for (const RunReport& report : reports)
      for (const WrittenFile& file : report.written) print_result(fmt::format("{}\n", file.path.string()));
  }
}

}  // namespace

int run_animate(const ShotOptions& options) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(thread_count(options.threads)));
  const Stopwatch load_watch;
  const LoadedShot loaded = load_shot(options);
  if (!options.quiet)
    for (const std::string& warning : loaded.warnings) say(fmt::format("{}\n", warning));
  const std::vector<Shot> runs = runs_of(loaded.shot);
  const std::vector<int> wanted = parse_frames(options.frames, loaded.shot.frame_count());
  const std::vector<std::filesystem::path> paths = require_outputs(loaded, options, runs);
  const Scene scene = bind_loaded(loaded, options);
  const double load_seconds = load_watch.seconds();

  note_signals();
  std::vector<RunReport> reports;
  {
    const int frames = wanted.empty() ? loaded.shot.frame_count() : wanted.back() + 1;
    const Verbosity verbosity = options.quiet ? Verbosity::quiet : Verbosity::normal;
    Progress progress(frames * static_cast<int>(runs.size()), verbosity);
    for (std::size_t begin = 0; begin < runs.size(); begin += together) {
      const std::span<const Shot> batch =
          std::span(runs).subspan(begin, std::min(together, runs.size() - begin));
      std::vector<Solved> solved = solve(loaded, batch, scene, wanted, progress);
      if (noted_signal() != 0) {
        say(fmt::format("\nflexkey: stopped by a signal after {} of {} frames; '{}' was not written\n",
                        solved.front().report.frames.size(), frames, paths[begin].string()));
        return stopped_by_signal + noted_signal();
      }
      for (std::size_t k = 0; k < batch.size(); ++k) {
        write(solved[k], batch[k], loaded, paths[begin + k], verbosity);
        reports.push_back(std::move(solved[k].report));
      }
    }
  }
  print_report(loaded, options, reports, load_seconds);
  if (!options.strict) return done;
  for (const RunReport& report : reports) {
    if (report.unconverged().empty()) continue;
    say(fmt::format("flexkey: error: {} of {} frames did not converge (--strict)\n",
                    report.unconverged().size(), report.frames.size()));
    return not_converged;
  }
  return done;
}

}  // namespace flexkey::cli
