#include "flexkey/timeline/read_solver.h"

#include <fmt/format.h>

#include <limits>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/scalar.h"
#include "flexkey/timeline/words.h"

namespace flexkey {
namespace {

using Preset = SolverSettings::Preset;
using System = SolverSettings::System;
using LocalScale = SolverSettings::LocalScale;
using Weights = SolverSettings::Weights;
using Cell = SolverSettings::Cell;

constexpr int most_iterations = 100'000;

std::optional<double> read_epsilon(const Node& node, Scope& scope) {
  const std::optional<double> epsilon = read_number(node, scope);
  if (!epsilon || *epsilon >= 0) return epsilon;
  scope.findings.error(node.where, fmt::format("epsilon {} is below 0 (0 is the paper's fit)", node.text));
  return std::nullopt;
}

std::optional<int> read_iterations(const Node& node, Scope& scope) {
  const std::optional<int> iterations = read_whole(node, scope);
  if (!iterations || (*iterations >= 1 && *iterations <= most_iterations)) return iterations;
  scope.findings.error(node.where, fmt::format("iterations {} is outside 1..{}", node.text, most_iterations));
  return std::nullopt;
}

std::optional<Weights> read_weights(const Node& node, Scope& scope) {
  return read_word<Weights>(node, "weights",
                            {{"clamped", Weights::clamped},
                             {"cotangent", Weights::cotangent},
                             {"intrinsic-delaunay", Weights::intrinsic_delaunay},
                             {"uniform", Weights::uniform}},
                            scope);
}

std::optional<Cell> read_cell(const Node& node, Scope& scope) {
  return read_word<Cell>(node, "cell", {{"spokes", Cell::spokes}, {"spokes-and-rims", Cell::spokes_and_rims}},
                         scope);
}

std::optional<LocalScale> read_local_scale(const Node& node, Scope& scope) {
  return read_word<LocalScale>(
      node, "local_scale",
      {{"axis", LocalScale::axis}, {"uniform", LocalScale::uniform}, {"none", LocalScale::none}}, scope);
}

std::optional<System> read_system(const Node& node, Scope& scope) {
  return read_word<System>(node, "system",
                           {{"least-squares", System::least_squares}, {"direct", System::direct}}, scope);
}

std::optional<double> read_max_step(const Node& node, Scope& scope) {
  if (node.kind == Node::Kind::scalar && node.text == "off") return std::numeric_limits<double>::infinity();
  const std::optional<double> step = read_angle(node, scope);
  if (!step || *step > 0) return step;
  scope.findings.error(node.where, fmt::format("max_step {} is not above 0", node.text));
  return std::nullopt;
}

Preset read_preset(const Node& node, Scope& scope) {
  return read_word<Preset>(node, "preset", {{"quality", Preset::quality}, {"paper", Preset::paper}}, scope)
      .value_or(Preset::quality);
}

/// Settings that each stand on their own but not together.
void check_together(const SolverSettings& settings, const Fields& fields, Scope& scope) {
  const Node* area_weighting = fields.value("area_weighting");
  if (area_weighting != nullptr && settings.area_weighting && settings.system == System::direct) {
    scope.findings.error(area_weighting->where,
                         "area_weighting scales the rows of system least-squares; direct has none");
  }
  const Node* cell = fields.value("cell");
  if (cell != nullptr && settings.cell == Cell::spokes_and_rims && settings.weights == Weights::uniform) {
    scope.findings.error(cell->where,
                         "cell spokes-and-rims takes cotangents for its weights; uniform ones are none");
  }
}

}  // namespace

SolverSettings preset_settings(Preset preset) {
  SolverSettings settings;
  settings.preset = preset;
  if (preset == Preset::paper) {
    settings.system = System::least_squares;
    settings.local_scale = LocalScale::axis;
    settings.epsilon = 0;
    settings.weights = Weights::cotangent;
    settings.iterations = 2;
    settings.predict = false;
    settings.accelerate = false;
    settings.max_step = std::numeric_limits<double>::infinity();
  }
  return settings;
}

SolverSettings read_solver(const Node& node, Scope& scope) {
  const std::optional<Fields> fields = read_fields(node, solver_keys, "'solver'", scope.findings);
  if (!fields) return {};
  const Node* preset = fields->value("preset");
  SolverSettings settings =
      preset_settings(preset != nullptr ? read_preset(*preset, scope) : Preset::quality);
  if (const Node* value = fields->value("system")) {
    settings.system = read_system(*value, scope).value_or(settings.system);
  }
  if (const Node* value = fields->value("local_scale")) {
    settings.local_scale = read_local_scale(*value, scope).value_or(settings.local_scale);
  }
  if (const Node* value = fields->value("epsilon")) {
    settings.epsilon = read_epsilon(*value, scope).value_or(settings.epsilon);
  }
  if (const Node* value = fields->value("weights")) {
    settings.weights = read_weights(*value, scope).value_or(settings.weights);
  }
  if (const Node* value = fields->value("cell")) {
    settings.cell = read_cell(*value, scope).value_or(settings.cell);
  }
  if (const Node* value = fields->value("area_weighting")) {
    settings.area_weighting = read_switch(*value, scope).value_or(settings.area_weighting);
  }
  if (const Node* value = fields->value("iterations")) {
    settings.iterations = read_iterations(*value, scope).value_or(settings.iterations);
  }
  if (const Node* value = fields->value("tolerance")) {
    settings.tolerance = read_tolerance(*value, scope).value_or(settings.tolerance);
  }
  if (const Node* value = fields->value("predict")) {
    settings.predict = read_switch(*value, scope).value_or(settings.predict);
  }
  if (const Node* value = fields->value("accelerate")) {
    settings.accelerate = read_switch(*value, scope).value_or(settings.accelerate);
  }
  if (const Node* value = fields->value("max_step")) {
    settings.max_step = read_max_step(*value, scope).value_or(settings.max_step);
  }
  check_together(settings, *fields, scope);
  return settings;
}

}  // namespace flexkey
