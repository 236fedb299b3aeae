#include "cli/session.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/console.h"
#include "cli/stopwatch.h"
#include "flexkey/timeline/parse.h"

namespace flexkey::cli {

namespace {

void drop_other_outputs(Shot& shot, Purpose purpose) {
  if (purpose == Purpose::files) shot.preview = {};
  if (purpose != Purpose::pictures) return;
  if (shot.preview.dir.empty()) shot.preview.dir = preview_folder(shot);  // who asks for pictures gets some
  shot.gltf = {};
  shot.caches.clear();
  shot.html = {};
}

}  // namespace

Session open_session(const ShotOptions& options, Purpose purpose) {
  const Stopwatch watch;
  Session session{options, load_shot(options), {}, {}, {}};
  drop_other_outputs(session.loaded.shot, purpose);
  if (!options.quiet)
    for (const std::string& warning : session.loaded.warnings) say(fmt::format("{}\n", warning));
  session.runs = runs_of(session.loaded.shot);
  session.picked = parse_frames(options.frames, session.loaded.shot.frame_count());
  if (!needs_whole_clip(session.loaded.shot.preview)) session.wanted = session.picked;
  session.scene = bind_loaded(session.loaded.shot, session.loaded, options);
  session.load_seconds = watch.seconds();
  return session;
}

bool is_picked(const Session& session, int frame) {
  const std::vector<int>& picked = session.picked;
  return picked.empty() || std::binary_search(picked.begin(), picked.end(), frame);
}

}  // namespace flexkey::cli
