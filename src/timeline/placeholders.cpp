#include "flexkey/timeline/placeholders.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flexkey/timeline/number.h"
#include "flexkey/timeline/parse.h"

namespace flexkey {
namespace {

/// A piece of a path: plain text, or a placeholder with its brackets.
struct Piece {
  std::string_view text;
  bool is_placeholder = false;
};

std::vector<Piece> pieces_of(std::string_view path) {
  std::vector<Piece> pieces;
  while (!path.empty()) {
    const std::size_t close = path.find('>');
    const std::size_t open = close == std::string_view::npos ? close : path.rfind('<', close);
    if (close == std::string_view::npos || open == std::string_view::npos) {
      const std::size_t plain = close == std::string_view::npos ? path.size() : close + 1;
      pieces.push_back({path.substr(0, plain)});
      path.remove_prefix(plain);
      continue;
    }
    pieces.push_back({path.substr(0, open)});
    pieces.push_back({path.substr(open, close + 1 - open), true});
    path.remove_prefix(close + 1);
  }
  return pieces;
}

/// A value as a part of a file's name.
std::string name_part(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '/' || c == '\\'; }, '_');
  return text;
}

/// The value of a placeholder in this shot, or nothing.
std::optional<std::string> value_of(std::string_view placeholder, const Shot& shot) {
  const std::string_view name = placeholder.substr(1, placeholder.size() - 2);
  if (name == "shot") return shot.name;
  if (name == "run" && !shot.swept.empty()) return fmt::format("{}", shot.run);
  for (const SweptValue& value : shot.swept)
    if (value.key == name) return name_part(value.text);
  if (name == "lambda" && shot.lambda.size() == 1) return number_text(shot.lambda.front().value);
  const auto variable = shot.variables.find(std::string(name));
  return variable != shot.variables.end() ? std::optional(variable->second) : std::nullopt;
}

/// An output's path where the timeline gives it.
struct PathInFile {
  const std::string& path;
  Mark where;
};

void report_unknown(std::string_view placeholder, const PathInFile& output, const Shot& shot,
                    Findings& findings) {
  std::vector<std::string> known = {"<shot>", "<lambda>"};
  for (const SweptValue& value : shot.swept)
    if (value.key != "lambda") known.push_back(fmt::format("<{}>", value.key));
  if (!shot.swept.empty()) known.emplace_back("<run>");
  for (const auto& [name, value] : shot.variables) known.push_back(fmt::format("<{}>", name));
  const std::string all =
      fmt::format("; known are {} and {}", fmt::join(known.begin(), known.end() - 1, ", "), known.back());
  findings.error(output.where, fmt::format("unknown placeholder '{}' in output path '{}'{}", placeholder,
                                           output.path, findings.proposal(placeholder, known, all)));
}

bool names(const std::string& path, std::string_view placeholder) {
  const std::vector<Piece> pieces = pieces_of(path);
  return std::any_of(pieces.begin(), pieces.end(),
                     [&](const Piece& piece) { return piece.is_placeholder && piece.text == placeholder; });
}

/// A variable may stand for its key, and the run's number for all.
bool names_key(const std::string& path, const std::string& key) {
  constexpr std::string_view variables = "vars.";
  const bool is_variable = key.starts_with(variables);
  return names(path, "<run>") || names(path, fmt::format("<{}>", key)) ||
         (is_variable && names(path, fmt::format("<{}>", key.substr(variables.size()))));
}

void check_placeholders(const PathInFile& output, const Shot& shot, Findings& findings) {
  for (const Piece& piece : pieces_of(output.path))
    if (piece.is_placeholder && piece.text != "<lambda>" && !value_of(piece.text, shot))
      report_unknown(piece.text, output, shot, findings);
  if (names(output.path, "<lambda>") && !value_of("<lambda>", shot)) {
    findings.error(output.where,
                   fmt::format("'<lambda>' in output path '{}' has no one value; it needs a constant "
                               "lambda or a sweep over it",
                               output.path));
  }
}

/// A path of which each run of a sweep needs one of its own.
void check_output_path(const PathInFile& output, const Shot& shot, Findings& findings) {
  check_placeholders(output, shot, findings);
  if (output.path.empty()) return;
  for (const SweptValue& value : shot.swept)
    if (value.varies && !names_key(output.path, value.key))
      findings.error(output.where,
                     fmt::format("output path '{}' does not name the swept key; write '<{}>' into it",
                                 output.path, value.key));
}

/// A sequence's pattern for one run. A percent sign in the shot's name does not begin a frame's number.
std::string expand_pattern(const std::string& pattern, const Shot& shot) {
  std::string expanded;
  for (const Piece& piece : pieces_of(pattern)) {
    const std::optional<std::string> value = piece.is_placeholder ? value_of(piece.text, shot) : std::nullopt;
    if (!value) expanded += piece.text;
    for (const char c : value.value_or("")) expanded.append(c == '%' ? 2 : 1, c);
  }
  return expanded;
}

}  // namespace

void check_output_paths(const Shot& shot, Findings& findings) {
  check_output_path({shot.gltf.path, shot.gltf.where}, shot, findings);
  for (const CacheOutput& cache : shot.caches) check_output_path({cache.path, cache.where}, shot, findings);
  check_output_path({shot.html.path, shot.html.where}, shot, findings);
  const PreviewOutput& preview = shot.preview;
  check_output_path({preview.dir, preview.where}, shot, findings);
  check_output_path({preview.gif.path, preview.gif.where}, shot, findings);
  check_placeholders({preview.sheet.path, preview.sheet.where}, shot, findings);  // may hold all runs
  check_placeholders({shot.report.path, shot.report.where}, shot, findings);      // does
}

std::string expand_placeholders(const std::string& path, const Shot& shot) {
  std::string expanded;
  for (const Piece& piece : pieces_of(path)) {
    const std::optional<std::string> value = piece.is_placeholder ? value_of(piece.text, shot) : std::nullopt;
    expanded += value ? *value : std::string(piece.text);
  }
  return expanded;
}

void expand_output_paths(Shot& run) {
  run.gltf.path = expand_placeholders(run.gltf.path, run);
  for (CacheOutput& cache : run.caches)
    cache.path = cache.is_sequence() ? expand_pattern(cache.path, run) : expand_placeholders(cache.path, run);
  run.html.path = expand_placeholders(run.html.path, run);
  run.preview.dir = expand_placeholders(run.preview.dir, run);
  run.preview.gif.path = expand_placeholders(run.preview.gif.path, run);
  run.preview.sheet.path = expand_placeholders(run.preview.sheet.path, run);
  run.report.path = expand_placeholders(run.report.path, run);
}

void check_runs_apart(const std::vector<Shot>& runs, Findings& findings) {
  std::map<std::string, int> taken;  // by which run
  const auto take = [&](const std::string& path, Mark where, const Shot& run) {
    if (path.empty()) return;
    const auto [found, is_new] = taken.emplace(path, run.run);
    if (!is_new && found->second != run.run)
      findings.error(where, fmt::format("runs {} and {} of the sweep would both write '{}'; write '<run>' "
                                        "into the path",
                                        found->second, run.run, path));
  };
  for (const Shot& run : runs) {
    take(run.gltf.path, run.gltf.where, run);
    for (const CacheOutput& cache : run.caches) take(cache.path, cache.where, run);
    take(run.html.path, run.html.where, run);
    take(run.preview.dir, run.preview.where, run);
    take(run.preview.gif.path, run.preview.gif.where, run);
  }
}

}  // namespace flexkey
