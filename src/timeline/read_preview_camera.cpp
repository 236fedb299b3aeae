#include "flexkey/timeline/read_preview_camera.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/scalar.h"
#include "flexkey/timeline/vector.h"
#include "flexkey/timeline/words.h"

namespace flexkey {
namespace {

using Fit = PreviewCamera::Fit;

constexpr double degree = std::numbers::pi / 180;
constexpr double rounding = 1e-9;  // degrees

/// Bounds in degrees.
struct AngleRange {
  double low = 0, high = 0;
};

std::optional<double> read_angle_in(const Node& node, std::string_view what, const AngleRange& range,
                                    Scope& scope) {
  const std::optional<double> angle = read_angle(node, scope);
  if (!angle) return std::nullopt;
  const double degrees = *angle / degree;
  if (degrees >= range.low - rounding && degrees <= range.high + rounding) return angle;
  scope.findings.error(node.where,
                       fmt::format("{} {} is outside {}deg..{}deg", what, node.text, range.low, range.high));
  return std::nullopt;
}

std::optional<double> read_zoom(const Node& node, Scope& scope) {
  const std::optional<double> zoom = read_number(node, scope);
  if (!zoom || (*zoom >= 1e-3 && *zoom <= 1e3)) return zoom;
  scope.findings.error(node.where, fmt::format("zoom {} is outside 0.001..1000", node.text));
  return std::nullopt;
}

}  // namespace

PreviewCamera read_preview_camera(const Node& node, Scope& scope) {
  PreviewCamera camera;
  const std::optional<Fields> fields = read_fields(node, camera_keys, "'camera'", scope.findings);
  if (!fields) return camera;
  if (const Node* value = fields->value("look_at")) camera.look_at = read_point(*value, scope);
  if (const Node* value = fields->value("azimuth"))
    camera.azimuth = read_angle(*value, scope).value_or(camera.azimuth);
  if (const Node* value = fields->value("elevation"))
    camera.elevation = read_angle_in(*value, "elevation", {-90, 90}, scope).value_or(camera.elevation);
  if (const Node* value = fields->value("fov"))
    camera.fov = read_angle_in(*value, "fov", {0.1, 170}, scope).value_or(camera.fov);
  if (const Node* value = fields->value("zoom")) camera.zoom = read_zoom(*value, scope).value_or(camera.zoom);
  if (const Node* value = fields->value("fit"))
    camera.fit =
        read_word<Fit>(*value, "fit", {{"clip", Fit::clip}, {"rest", Fit::rest}}, scope).value_or(camera.fit);
  if (const Node* value = fields->value("up"))
    camera.up = read_word<UpAxis>(*value, "up", {{"y", UpAxis::y}, {"z", UpAxis::z}}, scope);
  return camera;
}

}  // namespace flexkey
