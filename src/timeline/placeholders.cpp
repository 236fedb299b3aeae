#include "flexkey/timeline/placeholders.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

/// The value of a placeholder in this shot, or nothing.
std::optional<std::string> value_of(std::string_view placeholder, const Shot& shot) {
  if (placeholder == "<shot>") return shot.name;
  if (placeholder == "<lambda>" && shot.lambda.size() == 1) return number_text(shot.lambda.front().value);
  const auto variable = shot.variables.find(std::string(placeholder.substr(1, placeholder.size() - 2)));
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
  for (const auto& [name, value] : shot.variables) known.push_back(fmt::format("<{}>", name));
  const std::string all =
      fmt::format("; known are {} and {}", fmt::join(known.begin(), known.end() - 1, ", "), known.back());
  findings.error(output.where, fmt::format("unknown placeholder '{}' in output path '{}'{}", placeholder,
                                           output.path, findings.proposal(placeholder, known, all)));
}

bool names_lambda(const std::string& path) {
  const std::vector<Piece> pieces = pieces_of(path);
  return std::any_of(pieces.begin(), pieces.end(),
                     [](const Piece& piece) { return piece.is_placeholder && piece.text == "<lambda>"; });
}

void check_placeholders(const PathInFile& output, const Shot& shot, Findings& findings) {
  for (const Piece& piece : pieces_of(output.path))
    if (piece.is_placeholder && piece.text != "<lambda>" && !value_of(piece.text, shot))
      report_unknown(piece.text, output, shot, findings);
  if (names_lambda(output.path) && shot.sweep.lambda.empty() && shot.lambda.size() > 1) {
    findings.error(output.where,
                   fmt::format("'<lambda>' in output path '{}' has no one value; it needs a constant "
                               "lambda or a sweep over it",
                               output.path));
  }
}

/// A path of which each run of a sweep needs one of its own.
void check_output_path(const PathInFile& output, const Shot& shot, Findings& findings) {
  check_placeholders(output, shot, findings);
  if (shot.sweep.lambda.size() > 1 && !output.path.empty() && !names_lambda(output.path)) {
    findings.error(
        output.where,
        fmt::format("output path '{}' does not name the swept key; write '<lambda>' into it", output.path));
  }
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
}

std::string expand_placeholders(const std::string& path, const Shot& shot) {
  std::string expanded;
  for (const Piece& piece : pieces_of(path)) {
    const std::optional<std::string> value = piece.is_placeholder ? value_of(piece.text, shot) : std::nullopt;
    expanded += value ? *value : std::string(piece.text);
  }
  return expanded;
}

std::vector<Shot> runs_of(const Shot& shot) {
  std::vector<Shot> runs(std::max<std::size_t>(1, shot.sweep.lambda.size()), shot);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    Shot& run = runs[i];
    if (!shot.sweep.lambda.empty()) run.lambda = {{0, shot.sweep.lambda[i], {}}};
    run.sweep = {};
    run.gltf.path = expand_placeholders(shot.gltf.path, run);
    for (CacheOutput& cache : run.caches)
      cache.path =
          cache.is_sequence() ? expand_pattern(cache.path, run) : expand_placeholders(cache.path, run);
    run.html.path = expand_placeholders(shot.html.path, run);
    run.preview.dir = expand_placeholders(shot.preview.dir, run);
    run.preview.gif.path = expand_placeholders(shot.preview.gif.path, run);
    run.preview.sheet.path = expand_placeholders(shot.preview.sheet.path, run);
  }
  return runs;
}

}  // namespace flexkey
