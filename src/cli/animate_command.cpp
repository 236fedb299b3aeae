#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <span>

#include "cli/cache_outputs.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/gltf_options.h"
#include "cli/html_page.h"
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

/// Refuses, before hours of solving, what could not be written after.
void require_outputs(const LoadedShot& loaded, const ShotOptions& options, const std::vector<Shot>& runs) {
  const std::vector<std::filesystem::path> paths = plan_outputs(loaded, options, runs);
  check_caches(loaded, options, runs);
  check_pages(loaded, options, runs);
  if (paths.empty() && loaded.shot.caches.empty() && loaded.shot.html.path.empty())
    throw UsageError(
        fmt::format("{} names no output; add 'output: {}.glb'", loaded.shot.file, loaded.shot.name));
  for (const std::filesystem::path& path : paths)
    OutputFile probe(path);  // made and, uncommitted, removed again
  probe_caches(loaded, options, runs);
  probe_pages(options, runs);
}

/// Whether an output needs all frames at once.
bool needs_clip(const Shot& shot) {
  return !shot.gltf.path.empty() || !shot.html.path.empty();
}

Verbosity verbosity_of(const ShotOptions& options) {
  return options.quiet ? Verbosity::quiet : Verbosity::normal;
}

struct Solved {
  RunCaches caches;
  std::vector<HandleTrack> handles = {};  // where the GLB has them
  Clip clip = {};
  RunReport report = {};
};

/// Solves runs of one sweep together.
std::vector<Solved> solve(const LoadedShot& loaded, const ShotOptions& options, std::span<const Shot> runs,
                          const Scene& scene, Progress& progress) {
  std::vector<Solved> solved;
  for (const Shot& run : runs) {
    RunCaches caches(loaded, options, run);
    solved.push_back({std::move(caches)});
    if (run.gltf.handles) solved.back().handles = handle_tracks(scene);
  }
  AnimateHooks hooks;
  hooks.on_wanted = [&](std::size_t run, const SolvedFrame& frame) {
    solved[run].caches.add(frame);
    for (std::size_t h = 0; h < solved[run].handles.size(); ++h)
      solved[run].handles[h].matrices.push_back(frame.handles[h]);
  };
  hooks.keep = needs_clip(loaded.shot) ? Keep::frames : Keep::nothing;
  hooks.on_frame = [&](std::size_t run, const FrameReport& frame) {
    solved[run].report.frames.push_back(frame);
    progress.advance();
  };
  hooks.stop = [] { return noted_signal() != 0; };
  std::vector<Take> takes;
  for (const Shot& run : runs) takes.push_back({run, scene});
  const Stopwatch watch;
  const std::vector<int> wanted = parse_frames(options.frames, loaded.shot.frame_count());
  std::vector<Clip> clips = animate(takes, loaded.mesh, wanted, hooks);
  double seconds = watch.seconds();
  for (const Solved& run : solved) seconds -= run.caches.seconds();
  for (std::size_t k = 0; k < runs.size(); ++k) {
    RunReport& report = solved[k].report;
    solved[k].clip = std::move(clips[k]);
    report.solve_seconds = seconds / static_cast<double>(runs.size());
    report.claims_convergence = runs[k].solver.preset != SolverSettings::Preset::paper;
    if (report.frames.empty()) continue;
    report.lambda_first = report.frames.front().lambda;
    report.lambda_last = report.frames.back().lambda;
  }
  return solved;
}

/// Writes what needs all frames at once.
void write_clip(Solved& solved, const SolvedRun& run, const LoadedShot& loaded, const ShotOptions& options) {
  RunReport& report = solved.report;
  const int frames = static_cast<int>(solved.clip.frames.size());
  Progress progress(frames, verbosity_of(options), "Writing");
  GltfOptions gltf = gltf_options(run.shot, loaded);
  gltf.handles = std::move(solved.handles);
  gltf.on_progress = [&](double share) { progress.reach(static_cast<int>(share * frames)); };
  if (!run.shot.gltf.path.empty()) {
    const Stopwatch watch;
    const std::filesystem::path path = options.out_dir / run.shot.gltf.path;
    report.written.push_back({path, write_glb(solved.clip, gltf, path)});
    report.write_seconds = watch.seconds();
  }
  if (!run.shot.html.path.empty())
    report.pages.push_back(write_html_page(run, gltf, options.out_dir / run.shot.html.path, report.written));
}

/// Of the run's GLBs; the one in a page is that of the file beside it, where there is one.
std::vector<std::string> gltf_warnings(const RunReport& report) {
  std::vector<std::string> warnings;
  const auto take = [&](const auto& files) {
    for (const auto& file : files)
      warnings.insert(warnings.end(), file.gltf.warnings.begin(), file.gltf.warnings.end());
  };
  take(report.written);
  if (report.written.empty()) take(report.pages);
  return warnings;
}

/// What a signal left of a batch of runs, for a person.
std::string stop_text(const Solved& solved, const Shot& run, const ShotOptions& options, int frames) {
  std::vector<std::string> fates = solved.caches.fates();
  for (const std::string& path : {run.html.path, run.gltf.path})
    if (!path.empty())
      fates.insert(fates.begin(), fmt::format("'{}' was not written", (options.out_dir / path).string()));
  return fmt::format("\nflexkey: stopped by a signal after {} of {} frames; {}\n",
                     solved.report.frames.size(), frames, fmt::join(fates, ", "));
}

void print_report(const LoadedShot& loaded, const ShotOptions& options, const std::vector<RunReport>& reports,
                  double load_seconds) {
  if (!options.quiet) {
    for (const RunReport& report : reports)
      for (const std::string& warning : gltf_warnings(report)) say(fmt::format("warning: {}\n", warning));
    say(report_text(loaded, reports, load_seconds));
  }
  if (options.json) {
    print_result(fmt::format("{}\n", report_json(loaded, reports, load_seconds)));
  } else if (!options.quiet) {
    for (const RunReport& report : reports) {
      for (const WrittenFile& file : report.written) print_result(fmt::format("{}\n", file.path.string()));
      for (const WrittenCache& cache : report.caches) print_result(fmt::format("{}\n", cache.path.string()));
      for (const WrittenPage& page : report.pages) print_result(fmt::format("{}\n", page.path.string()));
    }
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
  require_outputs(loaded, options, runs);
  const Scene scene = bind_loaded(loaded, options);
  const double load_seconds = load_watch.seconds();

  note_signals();
  std::vector<RunReport> reports;
  {
    const int frames = wanted.empty() ? loaded.shot.frame_count() : wanted.back() + 1;
    Progress progress(frames * static_cast<int>(runs.size()), verbosity_of(options));
    for (std::size_t begin = 0; begin < runs.size(); begin += together) {
      const std::span<const Shot> batch =
          std::span(runs).subspan(begin, std::min(together, runs.size() - begin));
      std::vector<Solved> solved = solve(loaded, options, batch, scene, progress);
      if (noted_signal() != 0) {
        say(stop_text(solved.front(), batch.front(), options, frames));
        return stopped_by_signal + noted_signal();
      }
      for (std::size_t k = 0; k < batch.size(); ++k) {
        solved[k].report.caches = solved[k].caches.finish();
        if (needs_clip(batch[k])) write_clip(solved[k], {batch[k], scene, solved[k].clip}, loaded, options);
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
