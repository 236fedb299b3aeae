#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "flexkey/timeline/diagnostic.h"
#include "flexkey/timeline/shot.h"
#include "flexkey/timeline/sources.h"

namespace flexkey {

/// `--set key.path=value`: the value is YAML, as in the file.
struct Override {
  std::string key_path;
  std::string value;
};

struct ParsedShot {
  Shot shot;               // that of the first run, its output paths as they are written
  std::vector<Shot> runs;  // one, or one a run of the sweep: what the same timeline without `sweep`, with the
                           // run's values set, would give; their output paths without placeholders
  std::vector<Diagnostic> warnings;  // what is left out, and the like
};

/// Reads a timeline. `file` names it in messages and gives the shot its name ("-": "stdin").
/// sources: of the files that it names for motions. Throws TimelineError with every error of the text and of
/// the overrides, by position.
ParsedShot parse_shot(std::string_view text, const std::string& file,
                      const std::vector<Override>& overrides = {}, const Sources& sources = no_sources());

/// The text of a timeline file, at most 4 MiB; "-" is standard input. Throws TimelineError if it cannot be
/// read.
std::string read_timeline(const std::string& file);

/// An error about a place of the shot that shows only later (a group that the mesh has not), as a diagnostic
/// that knows whether the place is in the file or in a `--set`.
Diagnostic error_at(Mark where, const std::string& message, const std::vector<Override>& overrides);

/// Puts the shot's values into an output path: `<shot>`, `<lambda>` where λ is constant, variables, and of a
/// run of a sweep `<run>`, its number, and its values by their keys, such as `<solver.iterations>`.
std::string expand_placeholders(const std::string& path, const Shot& shot);

/// The folder of a shot's pictures where the timeline names none, placeholders and all.
std::string preview_folder(const Shot& shot);

}  // namespace flexkey
