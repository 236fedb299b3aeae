#include "flexkey/timeline/scalar.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include "flexkey/timeline/number.h"

namespace flexkey {
namespace {

/// The text of a scalar, or of the variable that it names; an error that says what belongs there for anything
/// else.
std::optional<std::string_view> text_of(const Node& node, std::string_view wanted, Scope& scope) {
  if (node.kind == Node::Kind::scalar) {
    const auto variable = scope.variables.find(node.text);
    return variable != scope.variables.end() ? variable->second : node.text;
  }
  scope.findings.error(node.where, fmt::format("{} belongs here, not {}", wanted, describe(node)));
  return std::nullopt;
}

bool begins_number(std::string_view text) {
  return !text.empty() && (std::string_view("0123456789.+-").find(text[0]) != std::string_view::npos);
}

void report_no_time(const Node& node, Scope& scope) {
  std::string problem = number_problem(node.text);
  if (problem.ends_with("is not a number")) problem = fmt::format("'{}' is not a time", node.text);
  scope.findings.error(node.where,
                       problem + "; times are seconds (1.5s), frames (36f) or names (hit, hit+4f)");
}

/// "hit", "hit+4f" or "hit-0.5s".
std::optional<double> read_named_time(const Node& node, Scope& scope) {
  const std::string_view text = trimmed(node.text);
  const std::size_t sign = text.find_first_of("+-");
  Node name = node;
  name.text = trimmed(text.substr(0, sign));
  const std::optional<double> base = look_up(scope.times, name, "time", "times", scope.findings);
  if (!base || sign == std::string_view::npos) return base;
  const std::optional<double> offset = parse_plain_time(trimmed(text.substr(sign + 1)), scope.fps);
  if (!offset || *offset < 0) {
    report_no_time(node, scope);
    return std::nullopt;
  }
  return text[sign] == '+' ? *base + *offset : *base - *offset;
}

std::optional<double> read_any_time(const Node& node, Scope& scope) {
  const std::optional<std::string_view> text = text_of(node, "a time", scope);
  if (!text) return std::nullopt;
  if (!text->empty() && !begins_number(*text)) return read_named_time(node, scope);
  const std::optional<double> time = parse_plain_time(*text, scope.fps);
  if (!time) report_no_time(node, scope);
  return time;
}

}  // namespace

std::optional<double> parse_plain_time(std::string_view text, double fps) {
  if (text.ends_with('f')) {
    const std::optional<double> frames = parse_number(text.substr(0, text.size() - 1));
    return frames ? std::optional(*frames / fps) : std::nullopt;
  }
  if (text.ends_with('s')) text.remove_suffix(1);
  return parse_number(text);
}

double snapped_to_frame(double time, double fps) {
  const double frame = std::round(time * fps);
  return std::abs(time * fps - frame) <= 1e-6 ? frame / fps : time;
}

std::optional<double> read_number(const Node& node, Scope& scope) {
  const std::optional<std::string_view> text = text_of(node, "a number", scope);
  if (!text) return std::nullopt;
  const std::optional<double> number = parse_number(*text);
  if (!number) scope.findings.error(node.where, number_problem(*text));
  return number;
}

std::optional<int> read_whole(const Node& node, Scope& scope) {
  const std::optional<std::string_view> text = text_of(node, "a whole number", scope);
  if (!text) return std::nullopt;
  const std::optional<int> number = parse_whole(*text);
  if (!number) {
    const bool is_number = parse_number(*text).has_value();
    scope.findings.error(
        node.where, is_number ? fmt::format("'{}' is not a whole number", *text) : number_problem(*text));
  }
  return number;
}

std::optional<double> read_time(const Node& node, Scope& scope) {
  const std::optional<double> time = read_any_time(node, scope);
  if (!time) return std::nullopt;
  const double snapped = snapped_to_frame(*time, scope.fps);
  if (snapped < 0) {
    scope.findings.error(node.where, fmt::format("time {} lies before the start, 0s", node.text));
    return std::nullopt;
  }
  return snapped + 0.0;  // -0 becomes 0
}

std::optional<double> read_angle(const Node& node, Scope& scope) {
  const std::optional<std::string_view> text = text_of(node, "an angle such as 90deg", scope);
  if (!text) return std::nullopt;
  const bool has_unit = text->ends_with("deg") || text->ends_with("rad");
  const std::string_view digits = has_unit ? text->substr(0, text->size() - 3) : *text;
  const std::optional<double> number = parse_number(digits);
  if (number && has_unit) return text->ends_with("rad") ? *number : *number / 180 * std::numbers::pi;
  if (number) {
    scope.findings.error(node.where, fmt::format("angle '{0}' needs its unit: {0}deg or {0}rad", *text));
  } else {
    scope.findings.error(
        node.where, fmt::format("'{}' is not an angle; write degrees (90deg) or radians (1.57rad)", *text));
  }
  return std::nullopt;
}

std::optional<Length> read_length(const Node& node, Scope& scope) {
  const std::optional<std::string_view> text = text_of(node, "a length such as 2 or 5%", scope);
  if (!text) return std::nullopt;
  const bool is_share = text->ends_with('%');
  const std::string_view digits = is_share ? text->substr(0, text->size() - 1) : *text;
  const std::optional<double> number = parse_number(digits);
  if (!number) {
    scope.findings.error(node.where, number_problem(*text) + "; lengths are mesh units (2) or shares (5%)");
    return std::nullopt;
  }
  return Length{is_share ? *number / 100 : *number, is_share};
}

std::optional<Length> read_distance(const Node& node, Scope& scope) {
  const std::optional<Length> length = read_length(node, scope);
  if (!length || length->value >= 0) return length;
  scope.findings.error(node.where, fmt::format("length {} is below 0", node.text));
  return std::nullopt;
}

std::optional<double> read_tolerance(const Node& node, Scope& scope) {
  const std::optional<Length> length = read_length(node, scope);
  if (!length) return std::nullopt;
  if (length->value > 0) return length->value;
  scope.findings.error(node.where,
                       fmt::format("tolerance {} is not above 0; it is a share of the diagonal such as "
                                   "0.1% or 0.001",
                                   node.text));
  return std::nullopt;
}

std::optional<bool> read_switch(const Node& node, Scope& scope) {
  constexpr std::array<std::string_view, 3> on = {"on", "true", "yes"};
  constexpr std::array<std::string_view, 3> off = {"off", "false", "no"};
  const std::optional<std::string_view> text = text_of(node, "on or off", scope);
  if (!text) return std::nullopt;
  for (std::size_t i = 0; i < on.size(); ++i) {
    if (*text == on[i]) return true;
    if (*text == off[i]) return false;
  }
  scope.findings.error(node.where, fmt::format("'{}' is neither on nor off", *text));
  return std::nullopt;
}

}  // namespace flexkey
