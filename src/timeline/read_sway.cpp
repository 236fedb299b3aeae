#include "flexkey/timeline/read_sway.h"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/scalar.h"
#include "flexkey/timeline/vector.h"

namespace flexkey {
namespace {

constexpr double most_hertz = 1e6;

std::optional<Length> read_amplitude(const Node& node, Sway::Kind kind, Scope& scope) {
  if (kind == Sway::Kind::offset) return read_length(node, scope);
  const std::optional<double> angle = read_angle(node, scope);
  return angle ? std::optional(Length{*angle, false}) : std::nullopt;
}

/// {amplitude, along} or {amplitude, axis}.
std::optional<Sway> read_sway(const Node& node, const Fields& fields, std::string_view place, Scope& scope) {
  const Entry *along = fields.find("along"), *axis = fields.find("axis");
  const Node* amplitude = require(fields, "amplitude", node.where, place, scope.findings);
  if (along != nullptr && axis != nullptr) {
    scope.findings.error(std::max(along, axis)->key.where,
                         fmt::format("'along' and 'axis' exclude each other in {}", place));
    return std::nullopt;
  }
  if (along == nullptr && axis == nullptr) {
    if (fields.lacks("along") && fields.lacks("axis"))
      scope.findings.error(
          node.where, fmt::format("{} needs 'along', to sway to and fro, or 'axis', to turn about", place));
    return std::nullopt;
  }
  Sway sway;
  sway.kind = along != nullptr ? Sway::Kind::offset : Sway::Kind::turn;
  const std::optional<Vec3> direction = read_axis(along != nullptr ? along->value : axis->value, scope);
  const std::optional<Length> size =
      amplitude != nullptr ? read_amplitude(*amplitude, sway.kind, scope) : std::nullopt;
  if (!direction || !size) return std::nullopt;
  sway.direction = *direction;
  sway.amplitude = *size;
  return sway;
}

double read_frequency(const Fields& fields, Scope& scope) {
  const Node* node = fields.value("frequency");
  const double frequency = node != nullptr ? read_number(*node, scope).value_or(1) : 1;
  if (frequency > 0 && frequency <= most_hertz) return frequency;
  scope.findings.error(node->where, fmt::format("frequency {} is outside 0..{} swings a second, above 0",
                                                node->text, most_hertz));
  return 1;
}

std::optional<Wave> read_wave(const Node& node, std::string_view place, Scope& scope) {
  const std::optional<Fields> fields = read_fields(node, wave_keys, place, scope.findings);
  if (!fields) return std::nullopt;
  const std::optional<Sway> sway = read_sway(node, *fields, place, scope);
  const double frequency = read_frequency(*fields, scope);
  const Node* phase = fields->value("phase");
  const double radians = phase != nullptr ? read_angle(*phase, scope).value_or(0) : 0;
  return sway ? std::optional(Wave{*sway, frequency, radians}) : std::nullopt;
}

std::optional<Noise> read_noise(const Node& node, std::string_view place, Scope& scope) {
  const std::optional<Fields> fields = read_fields(node, noise_keys, place, scope.findings);
  if (!fields) return std::nullopt;
  const std::optional<Sway> sway = read_sway(node, *fields, place, scope);
  const double frequency = read_frequency(*fields, scope);
  const Node* node_of_seed = fields->value("seed");
  const int seed = node_of_seed != nullptr ? read_whole(*node_of_seed, scope).value_or(0) : 0;
  if (seed < 0) scope.findings.error(node_of_seed->where, fmt::format("seed {} is below 0", seed));
  return sway ? std::optional(Noise{*sway, frequency, static_cast<std::uint32_t>(seed)}) : std::nullopt;
}

template <class Value, class Read>
std::vector<Value> read_one_or_more(const Node& node, const Read& read) {
  std::vector<Value> values;
  const auto take = [&](const Node& one) {
    if (const std::optional<Value> value = read(one)) values.push_back(*value);
  };
  if (node.kind != Node::Kind::list) take(node);
  for (const Node& item : node.items) take(item);
  return values;
}

}  // namespace

std::vector<Wave> read_waves(const Node& node, std::string_view place, Scope& scope) {
  return read_one_or_more<Wave>(node, [&](const Node& one) { return read_wave(one, place, scope); });
}

std::vector<Noise> read_noises(const Node& node, std::string_view place, Scope& scope) {
  return read_one_or_more<Noise>(node, [&](const Node& one) { return read_noise(one, place, scope); });
}

}  // namespace flexkey
