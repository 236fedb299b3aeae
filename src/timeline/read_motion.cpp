#include "flexkey/timeline/read_motion.h"

#include <fmt/format.h>

#include <string>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/read_names.h"
#include "flexkey/timeline/read_track.h"
#include "flexkey/timeline/scalar.h"
#include "flexkey/timeline/vector.h"
#include "flexkey/timeline/words.h"

namespace flexkey {
namespace {

/// 0..1: "25%" or "0.25".
std::optional<double> read_share(const Node& node, Scope& scope) {
  const std::optional<Length> share = read_length(node, scope);
  if (!share || (share->value >= 0 && share->value <= 1))
    return share ? std::optional(share->value) : std::nullopt;
  scope.findings.error(node.where, fmt::format("{} is outside 0..100% of the path", node.text));
  return std::nullopt;
}

}  // namespace

std::optional<Vec3> read_factors(const Node& node, Scope& scope) {
  std::optional<Vec3> factors;
  if (node.kind == Node::Kind::scalar) {
    const std::optional<double> factor = read_number(node, scope);
    if (factor) factors = Vec3::Constant(*factor);
  } else {
    factors = read_vector(node, scope);
  }
  if (!factors || factors->minCoeff() > 0) return factors;
  scope.findings.error(
      node.where, "scale factors are above 0; 0 would collapse the handle and below 0 turn it inside out");
  return std::nullopt;
}

Track<Vec3> read_move(const Node& node, std::string_view place, Scope& scope) {
  return track_of<Vec3>(read_track(node, place, scope),
                        [&](const Node& value) { return read_vector(value, scope); });
}

Track<Vec3> read_to(const Node& node, std::string_view place, Scope& scope) {
  return track_of<Vec3>(read_track(node, place, scope),
                        [&](const Node& value) { return read_point(value, scope); });
}

Track<Vec3> read_scale(const Node& node, std::string_view place, Scope& scope) {
  return track_of<Vec3>(read_track(node, place, scope),
                        [&](const Node& value) { return read_factors(value, scope); });
}

Track<Curve> read_curve_track(const Node& node, std::string_view place, Scope& scope) {
  const std::string curve_place = fmt::format("a key of {}", place);
  return track_of<Curve>(read_track(node, place, scope),
                         [&](const Node& value) { return read_curve(value, curve_place, scope); });
}

std::optional<Follow> read_follow(const Node& node, std::string_view place, Scope& scope) {
  const std::optional<Fields> fields = read_fields(node, follow_keys, place, scope.findings);
  if (!fields) return std::nullopt;
  Follow follow;
  const Node* path = require(*fields, "path", node.where, place, scope.findings);
  const Node* keys = require(*fields, "keys", node.where, place, scope.findings);
  const std::optional<Curve> curve =
      path != nullptr ? read_curve(*path, fmt::format("'path' in {}", place), scope) : std::nullopt;
  if (curve) follow.path = *curve;
  if (path != nullptr && curve && curve->kind == Curve::Kind::rest)
    scope.findings.error(path->where, fmt::format("{} follows a path; 'rest' is none", place));
  if (keys != nullptr)
    follow.shares = track_of<double>(read_keys(*keys, track_ease(*fields, scope), place, scope),
                                     [&](const Node& value) { return read_share(value, scope); });
  if (const Node* orient = fields->value("orient")) {
    using Orient = Follow::Orient;
    follow.orient =
        read_word<Orient>(*orient, "orient", {{"none", Orient::none}, {"tangent", Orient::tangent}}, scope)
            .value_or(Orient::none);
  }
  return follow;
}

}  // namespace flexkey
