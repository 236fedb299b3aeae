#include "cli/conclusion.h"

#include <fmt/format.h>

#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/output_paths.h"
#include "flexkey/mesh/output_file.h"
#include "flexkey/timeline/parse.h"

namespace flexkey::cli {
namespace {

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

/// Beside those of other parts of a sweep where only one is done: "report.2-of-4.json".
std::filesystem::path report_path(const Session& session) {
  const std::string& named = session.loaded.shot.report.path;
  if (named.empty()) return {};
  std::filesystem::path path = session.options.out_dir / named;
  const std::optional<Chunk>& chunk = session.options.chunk;
  if (chunk && chunk->of > 1)
    path.replace_extension(fmt::format(".{}-of-{}{}", chunk->number, chunk->of, path.extension().string()));
  return path;
}

void write_report(const std::filesystem::path& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace

void check_report(const Session& session) {
  const std::filesystem::path path = report_path(session);
  if (path.empty()) return;
  if (replaces_input(session.loaded, path))
    throw TimelineError(
        session.loaded.shot.file,
        {error_at(session.loaded.shot.report.where,
                  fmt::format("the output '{}' would replace an input; give it another name", path.string()),
                  session.options.overrides())});
  if (!is_special(path)) OutputFile probe(path);  // made and, uncommitted, removed again
}

void note(const Session& session, std::vector<RunReport> reports, Doings& doings) {
  FamilyReport& family = doings.families.emplace_back(family_report(session.loaded, session.load_seconds));
  family.runs = std::move(reports);
  doings.report = report_path(session);
  if (session.options.quiet) return;
  for (const RunReport& report : family.runs)
    for (const std::string& warning : gltf_warnings(report)) say(fmt::format("warning: {}\n", warning));
  say(report_text(family));
}

int conclude(const ShotOptions& options, const Doings& doings) {
  const std::string text =
      options.json || !doings.report.empty() ? fmt::format("{}\n", report_json(doings.families)) : "";
  if (!doings.report.empty()) write_report(doings.report, text);
  if (options.json) {
    print_result(text);
  } else if (!options.quiet) {
    for (const std::string& result : doings.results) print_result(fmt::format("{}\n", result));
  }
  if (!options.strict) return done;
  for (const FamilyReport& family : doings.families)
    for (const RunReport& report : family.runs) {
      const std::vector<std::string> poses = report.unconverged_poses();
      if (report.unconverged().empty() && poses.empty()) continue;
      say(report.unconverged().empty()
              ? fmt::format("flexkey: error: poses did not converge (--strict): {}\n", fmt::join(poses, ", "))
              : fmt::format("flexkey: error: {} of {} frames did not converge (--strict)\n",
                            report.unconverged().size(), report.frames.size()));
      return not_converged;
    }
  return done;
}

int conclude_stopped(const Session& session, const RunStates& states, std::size_t frames,
                     std::vector<std::string> fates) {
  fates.emplace_back(states.is_kept() ? "the same command goes on from there" : "no state was kept");
  say(fmt::format("\nflexkey: stopped by a signal after {} of {} frames; {}\n", frames, session.step_count(),
                  fmt::join(fates, ", ")));
  return stopped_by_signal + noted_signal();
}

}  // namespace flexkey::cli
