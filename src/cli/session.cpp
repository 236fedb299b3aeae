#include "cli/session.h"

#include <fmt/format.h>

#include "cli/console.h"
#include "cli/stopwatch.h"
#include "flexkey/timeline/parse.h"

namespace flexkey::cli {

Session open_session(const ShotOptions& options) {
  const Stopwatch watch;
  Session session{options, load_shot(options), {}, {}};
  if (!options.quiet)
    for (const std::string& warning : session.loaded.warnings) say(fmt::format("{}\n", warning));
  session.runs = runs_of(session.loaded.shot);
  session.wanted = parse_frames(options.frames, session.loaded.shot.frame_count());
  session.scene = bind_loaded(session.loaded, options);
  session.load_seconds = watch.seconds();
  return session;
}

}  // namespace flexkey::cli
