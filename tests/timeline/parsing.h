#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "flexkey/timeline/parse.h"

namespace flexkey {

/// A whole timeline of one anchored handle, with more top-level lines behind it; they begin at line 4.
inline std::string with_base(const std::string& lines) {
  return "mesh: bar.obj\nhandles:\n  base: {select: {axis: z, below: 1%}}\n" + lines;
}

inline Shot parse(const std::string& text, const std::vector<Override>& overrides = {}) {
  return parse_shot(text, "shot.yaml", overrides).shot;
}

/// The runs of a timeline's sweep, or its only one.
inline std::vector<Shot> runs_of(const std::string& text, const std::vector<Override>& overrides = {},
                                 const Sources& sources = no_sources()) {
  return parse_shot(text, "shot.yaml", overrides, sources).runs;
}

/// A shot whose handle 'tip' has these lines beside its selection; they begin at line 5.
inline std::string with_tip(const std::string& lines) {
  return "mesh: bar.obj\nhandles:\n  tip:\n    select: {axis: z, above: 99%}\n" + lines;
}

inline Handle parse_tip(const std::string& lines) {
  return parse(with_tip(lines)).handles.at(0);
}

/// Files for a timeline, by path.
inline Sources files(std::map<std::string, std::string> texts) {
  Sources sources = no_sources();
  sources.text = [texts = std::move(texts)](const std::string& path) {
    const auto found = texts.find(path);
    if (found == texts.end()) throw InputError("cannot read '" + path + "'");
    return found->second;
  };
  return sources;
}

/// Every error of a text as the program would print it, one a line; empty if there is none.
inline std::string errors_of(const std::string& text, const std::vector<Override>& overrides = {},
                             const Sources& sources = no_sources()) {
  try {
    parse_shot(text, "shot.yaml", overrides, sources);
  } catch (const TimelineError& error) {
    return error.what();
  }
  return {};
}

inline std::vector<std::string> warnings_of(const std::string& text) {
  std::vector<std::string> lines;
  for (const Diagnostic& warning : parse_shot(text, "shot.yaml").warnings) {
    lines.push_back(format_diagnostic("shot.yaml", warning));
  }
  return lines;
}

}  // namespace flexkey
