#include "flexkey/timeline/parse.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "flexkey/mesh/limits.h"
#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/overrides.h"
#include "flexkey/timeline/placeholders.h"
#include "flexkey/timeline/read_attachments.h"
#include "flexkey/timeline/read_gltf_output.h"
#include "flexkey/timeline/read_handle.h"
#include "flexkey/timeline/read_lambda.h"
#include "flexkey/timeline/read_mesh_source.h"
#include "flexkey/timeline/read_names.h"
#include "flexkey/timeline/read_output.h"
#include "flexkey/timeline/read_pose.h"
#include "flexkey/timeline/read_preview_output.h"
#include "flexkey/timeline/read_rigid.h"
#include "flexkey/timeline/read_selection.h"
#include "flexkey/timeline/read_solver.h"
#include "flexkey/timeline/read_track.h"
#include "flexkey/timeline/scalar.h"
#include "flexkey/timeline/source_text.h"
#include "flexkey/timeline/sweep.h"
#include "flexkey/timeline/variables.h"
#include "flexkey/timeline/words.h"

namespace flexkey {
namespace {

void check_version(const Node& node, Scope& scope) {
  const std::optional<int> version = read_whole(node, scope);
  if (!version || *version == 1) return;
  scope.findings.error(node.where,
                       fmt::format("version {} is not known; this program reads version 1", node.text));
}

Loop read_loop(const Node& node, Scope& scope) {
  return read_word<Loop>(node, "loop",
                         {{"none", Loop::none}, {"cycle", Loop::cycle}, {"ping-pong", Loop::ping_pong}},
                         scope)
      .value_or(Loop::none);
}

/// A cycle comes round after a whole number of frames.
void check_cycle(const Shot& shot, Mark where, Findings& findings) {
  const double frames = shot.duration * shot.fps;
  if (shot.loop != Loop::cycle || findings.has_errors()) return;
  if (shot.frame_count() < 1) {
    findings.error(where, fmt::format("a cycle lasts a frame at least, and the shot {:g}s", shot.duration));
  } else if (std::abs(frames - std::round(frames)) > 1e-6) {
    findings.warning(where, fmt::format("the cycle's {:g}s are {:g} frames; it comes round after {}",
                                        shot.duration, frames, shot.frame_count()));
  }
}

std::optional<double> read_fps(const Node& node, Scope& scope) {
  const std::optional<double> fps = read_number(node, scope);
  if (!fps || (*fps > 0 && *fps <= limits::frames_a_second)) return fps;
  scope.findings.error(node.where, fmt::format("fps {} is outside 0..{} (frames a second, above 0)",
                                               node.text, limits::frames_a_second));
  return std::nullopt;
}

/// What the values of the other keys are read with; the frame rate first, since times may be frames.
void read_definitions(const Fields& fields, Scope& scope) {
  if (const Node* fps = fields.value("fps")) scope.fps = read_fps(*fps, scope).value_or(scope.fps);
  if (const Node* ease = fields.value("ease")) scope.ease = read_easing(*ease, scope).value_or(scope.ease);
  if (const Node* times = fields.value("times")) read_times(*times, scope);
  if (const Node* points = fields.value("points")) read_named_points(*points, scope);
  if (const Node* paths = fields.value("paths")) read_paths(*paths, scope);
  if (const Node* poses = fields.value("poses")) read_poses(*poses, scope);
}

/// Seconds; the last key where the file gives none. Every key must have been read.
double read_duration(const Fields& fields, Scope& scope) {
  const Node* node = fields.value("duration");
  const double duration = node != nullptr ? read_time(*node, scope).value_or(0) : scope.last_key;
  const double frames = std::floor(duration * scope.fps + 1e-6) + 1;
  if (frames <= limits::frames) return duration;
  scope.findings.error(
      node != nullptr ? node->where : scope.last_key_where,
      fmt::format("the shot would have {:.0f} frames; {} are the most", frames, limits::frames));
  return 0;
}

/// What the timeline solves: everything but times.
Shot read_contents(const Fields& fields, Scope& scope) {
  constexpr std::string_view place = "a timeline";
  constexpr Mark start{1, 1};
  Shot shot;
  if (const Node* node = require(fields, "mesh", start, place, scope.findings)) {
    shot.mesh = read_mesh_source(*node, scope);
  }
  if (const Node* node = fields.value("roi")) shot.roi = read_selection(*node, "'roi'", scope);
  if (const Node* node = require(fields, "handles", start, place, scope.findings)) {
    shot.handles = read_handles(*node, scope);
  }
  if (const Node* node = fields.value("rigid")) shot.rigid = read_rigid(*node, scope);
  if (const Node* node = fields.value("attach")) shot.attachments = read_attachments(*node, scope);
  shot.lambda = {{0, default_lambda, {}}};
  if (const Node* node = fields.value("lambda")) {
    Lambda lambda = read_lambda(*node, scope);
    shot.lambda = std::move(lambda.keys);
    shot.regions = std::move(lambda.regions);
  }
  if (const Node* node = fields.value("solver")) shot.solver = read_solver(*node, scope);
  if (const Node* node = fields.value("output")) {
    Outputs outputs = read_output(*node, scope);
    shot.gltf = std::move(outputs.gltf);
    shot.caches = std::move(outputs.caches);
    shot.html = std::move(outputs.html);
    shot.preview = std::move(outputs.preview);
    shot.report = std::move(outputs.report);
  }
  if (const Node* node = fields.value("clips")) shot.clips = read_clips(*node, scope);
  return shot;
}

/// The variables that are one word, for placeholders.
std::map<std::string, std::string> words_of(const Variables& variables) {
  std::map<std::string, std::string> words;
  for (const auto& [name, value] : variables)
    if (value.kind == Node::Kind::scalar) words[name] = value.text;
  return words;
}

/// A run of a sweep, or the only one.
struct RunOfSweep {
  std::vector<SweptValue> swept;
  int number = 0;
};

Shot read_shot(Node root, const RunOfSweep& run, const Sources& sources, Findings& findings) {
  const std::size_t before = findings.errors().size();
  const Variables variables = put_variables(root, findings);
  if (findings.errors().size() > before) return {};  // a name in place of its value is wrong everywhere
  const std::optional<Fields> fields = read_fields(root, shot_keys, "", findings);
  if (!fields) return {};
  Scope scope(findings, sources);
  scope.variables = words_of(variables);
  if (const Node* node = fields->value("version")) check_version(*node, scope);
  read_definitions(*fields, scope);
  Shot shot = read_contents(*fields, scope);
  shot.variables = scope.variables;
  shot.fps = scope.fps;
  shot.duration = read_duration(*fields, scope);
  if (const Node* node = fields->value("loop")) {
    shot.loop = read_loop(*node, scope);
    check_cycle(shot, node->where, findings);
  }
  shot.swept = run.swept;
  shot.run = run.number;
  complete_preview(shot, findings);
  return shot;
}

/// Reads one run of a sweep: the timeline with the run's values in it.
Shot read_run(Node root, const SweepPlan& plan, std::size_t number, const Sources& sources,
              Findings& findings) {
  RunOfSweep run{{}, static_cast<int>(number)};
  for (const auto& [named, where, value] : plan.runs[number]) {
    put_value(root, {named.key, where}, value, findings);
    run.swept.push_back(named);
  }
  return read_shot(std::move(root), run, sources, findings);
}

std::vector<Shot> read_runs(Node root, const Sources& sources, Findings& findings) {
  constexpr std::size_t enough_errors = 100;
  const SweepPlan plan = take_sweep(root, sources, findings);
  const bool is_understood = !findings.has_errors();
  std::vector<Shot> runs;
  for (std::size_t n = 0; n < plan.runs.size() && findings.errors().size() < enough_errors; ++n) {
    Findings own;
    runs.push_back(read_run(root, plan, n, sources, own));
    if (is_understood) check_output_paths(runs.back(), own);
    findings.take(own, plan.note_of(n));
  }
  return runs;
}

/// The timeline's tree with its overrides; nothing if there is none to read.
std::optional<Node> read_tree(std::string_view text, const std::vector<Override>& overrides,
                              Findings& findings) {
  std::optional<Node> root;
  try {
    root = parse_yaml(text, findings);
  } catch (const YamlError& error) {
    findings.error(error.where(), error.what());
    return std::nullopt;
  }
  if (root->kind == Node::Kind::null) {
    findings.error({1, 1}, "the timeline is empty");
    return std::nullopt;
  }
  int number = 0;
  for (const Override& change : overrides) root = with_override(std::move(*root), change, ++number, findings);
  return root;
}

std::vector<Diagnostic> with_sources(std::vector<Diagnostic> diagnostics,
                                     const std::vector<Override>& overrides) {
  for (Diagnostic& diagnostic : diagnostics) {
    diagnostic.source = error_at(diagnostic.where, diagnostic.message, overrides).source;
  }
  return diagnostics;
}

std::string name_of(const std::string& file) {
  return file == "-" ? "stdin" : std::filesystem::path(file).stem().string();
}

}  // namespace

Diagnostic error_at(Mark where, const std::string& message, const std::vector<Override>& overrides) {
  Diagnostic diagnostic{Diagnostic::Severity::error, where, message};
  const auto number = static_cast<std::size_t>(where.column);
  const bool is_override = where.line == 0 && where.column > 0 && number <= overrides.size();
  if (is_override) diagnostic.source = "--set " + overrides[number - 1].key_path;
  return diagnostic;
}

ParsedShot parse_shot(std::string_view text, const std::string& file, const std::vector<Override>& overrides,
                      const Sources& sources) {
  Findings findings;
  std::optional<Node> root = read_tree(text, overrides, findings);
  ParsedShot parsed;
  if (root) parsed.runs = read_runs(std::move(*root), sources, findings);
  if (findings.has_errors()) throw TimelineError(file, with_sources(findings.errors(), overrides));
  for (Shot& run : parsed.runs) {
    run.file = file;
    run.name = name_of(file);
  }
  parsed.shot = parsed.runs.front();
  for (Shot& run : parsed.runs) expand_output_paths(run);
  check_runs_apart(parsed.runs, findings);
  if (findings.has_errors()) throw TimelineError(file, with_sources(findings.errors(), overrides));
  parsed.warnings = with_sources(findings.warnings(), overrides);
  return parsed;
}

}  // namespace flexkey
