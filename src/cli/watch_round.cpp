#include "cli/watch_round.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <optional>

#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/previews.h"
#include "cli/run_outputs.h"
#include "cli/run_states.h"
#include "cli/session.h"
#include "cli/stopwatch.h"
#include "cli/write_outputs.h"

namespace flexkey::cli {
namespace {

/// Drafts are small, of the surface as it is solved, and do not wait for the last frame.
void make_drafts(Shot& shot) {
  PreviewOutput& preview = shot.preview;
  preview.quality = PreviewOutput::Quality::draft;
  preview.camera.fit = PreviewCamera::Fit::rest;
  if (preview.style == PreviewOutput::Style::displacement) preview.style = PreviewOutput::Style::clay;
  preview.subdivide = 0;
  constexpr int wide = 640;  // pixels
  if (preview.width > wide) {
    preview.height = std::max(1, preview.height * wide / preview.width);
    preview.width = wide;
  }
  preview.gif = {};
  preview.sheet = {};
}

bool names_outputs(const Shot& shot) {
  return !shot.gltf.path.empty() || !shot.caches.empty() || !shot.html.path.empty() ||
         !shot.preview.dir.empty();
}

void say_line(const std::string& text) {
  say(fmt::format("{:%H:%M:%S} {}\n", fmt::localtime(std::time(nullptr)), text));
}

/// "solved 49 frames" or "nothing to solve": what was done now.
std::string solved_text(const std::vector<RunReport>& reports) {
  std::size_t solved = 0, unconverged = 0;
  for (const RunReport& report : reports) {
    solved += report.solved_now;
    if (report.claims_convergence) unconverged += report.unconverged().size();
  }
  const std::string text =
      solved == 0 ? std::string("nothing to solve") : fmt::format("solved {} frames", solved);
  return unconverged == 0 ? text : fmt::format("{}, {} did not converge", text, unconverged);
}

/// "12 pictures in out/nose", of what was drawn now.
std::string drawn_text(const std::vector<RunReport>& reports) {
  std::size_t drawn = 0;
  std::string folder;
  for (const RunReport& report : reports)
    for (const WrittenPreview& preview : report.previews) {
      drawn += preview.drawn;
      folder = preview.path.parent_path().string();
    }
  return drawn == 0 ? std::string("no picture changed") : fmt::format("drew {} drafts in {}", drawn, folder);
}

/// Solves the shot and draws its drafts. Returns what was done, or nothing where a signal stopped it.
std::optional<std::string> draft(const ReadTimeline& timeline, const ShotOptions& options) {
  std::vector<RunReport> reports;
  for (std::size_t family = 0; family < timeline.families.size(); ++family) {
    Session session =
        open_session(timeline, family, options, draws_previews() ? Purpose::pictures : Purpose::files);
    for (const std::string& warning : session.loaded.warnings) say(fmt::format("{}\n", warning));
    if (draws_previews()) {
      for (Shot& run : session.runs) make_drafts(run);
      session.loaded.shot = session.runs.front();
      session.wanted = session.picked;
      require_outputs(session);
    }
    RunStates states(session, StateUse::helps);
    note_signals();
    for (RunReport& report : write_outputs(session, states).reports) reports.push_back(std::move(report));
    if (noted_signal() != 0) return std::nullopt;
  }
  const std::string solved = solved_text(reports);
  return draws_previews() ? fmt::format("{}, {}", solved, drawn_text(reports)) : solved;
}

/// Writes what the shot names from what is solved. Returns the paths.
std::vector<std::string> write_all(const ReadTimeline& timeline, const ShotOptions& options) {
  std::vector<std::string> written;
  for (std::size_t family = 0; family < timeline.families.size(); ++family) {
    const Session session = open_session(timeline, family, options, Purpose::all);
    if (!names_outputs(session.loaded.shot)) return {};
    require_outputs(session);
    RunStates states(session, StateUse::helps);
    for (std::string& path : results_of(write_outputs(session, states).reports))
      written.push_back(std::move(path));
  }
  return written;
}

}  // namespace

int run_round(const ShotOptions& options, const std::string& cause) {
  ShotOptions quiet = options;
  quiet.quiet = true;  // but for the lines here
  const Stopwatch watch;
  const ReadTimeline timeline = read_shot(quiet);
  const std::optional<std::string> drafted = draft(timeline, quiet);
  if (!drafted) return stopped_by_signal + noted_signal();
  say_line(fmt::format("{}: {} ({:.2f} s)", cause, *drafted, watch.seconds()));
  const std::vector<std::string> written = write_all(timeline, quiet);
  if (noted_signal() != 0) return stopped_by_signal + noted_signal();
  if (!written.empty())
    say_line(fmt::format("wrote {} ({:.2f} s)", fmt::join(written, ", "), watch.seconds()));
  return done;
}

}  // namespace flexkey::cli
