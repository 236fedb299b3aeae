#include "cli/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "cli/console.h"
#include "cli/stopwatch.h"
#include "flexkey/timeline/parse.h"

namespace flexkey::cli {

namespace {

void drop_other_outputs(Shot& shot, Purpose purpose) {
  if (purpose == Purpose::files) shot.preview = {};
  if (purpose != Purpose::pictures) return;
  if (shot.preview.dir.empty())
    shot.preview.dir = expand_placeholders(preview_folder(shot), shot);  // who asks for pictures gets some
  shot.gltf = {};
  shot.caches.clear();
  shot.html = {};
}

/// Increasing; empty: all.
std::vector<int> picked_frames(const ShotOptions& options, int frame_count) {
  std::vector<int> frames = parse_frames(options.frames, frame_count);
  if (!options.part) return frames;
  if (frames.empty()) {
    frames.resize(static_cast<std::size_t>(frame_count));
    std::iota(frames.begin(), frames.end(), 0);
  }
  const auto [first, last] = range_of(*options.part, frames.size(), "frame");
  return {frames.begin() + first, frames.begin() + last};
}

}  // namespace

Session open_session(const ReadTimeline& timeline, std::size_t family, const ShotOptions& options,
                     Purpose purpose) {
  const Stopwatch watch;
  Session session{options, timeline, family, load_family(timeline, family, options), {}, {}, {}};
  session.runs = session.loaded.runs;
  for (Shot& run : session.runs) drop_other_outputs(run, purpose);
  session.loaded.shot = session.runs.front();
  session.picked = picked_frames(options, session.loaded.shot.frame_count());
  if (!needs_whole_clip(session.loaded.shot.preview)) session.wanted = session.picked;
  session.scene = bind_loaded(session.loaded.shot, session.loaded, options);
  session.load_seconds = watch.seconds();
  return session;
}

void say_warnings(const Session& session) {
  if (session.options.quiet) return;
  for (const std::string& warning : session.loaded.warnings) say(fmt::format("{}\n", warning));
}

bool is_picked(const Session& session, int frame) {
  const std::vector<int>& picked = session.picked;
  return picked.empty() || std::binary_search(picked.begin(), picked.end(), frame);
}

}  // namespace flexkey::cli
