#include "flexkey/timeline/vector.h"

#include <fmt/format.h>

#include <string_view>

#include "flexkey/timeline/scalar.h"

namespace flexkey {

std::optional<Vec3> read_vector(const Node& node, Scope& scope) {
  if (node.kind != Node::Kind::list || node.items.size() != 3) {
    const std::string found =
        node.kind == Node::Kind::list ? fmt::format("a list of {}", node.items.size()) : describe(node);
    scope.findings.error(node.where, fmt::format("three numbers [x, y, z] belong here, not {}", found));
    return std::nullopt;
  }
  const std::optional<double> x = read_number(node.items[0], scope);
  const std::optional<double> y = read_number(node.items[1], scope);
  const std::optional<double> z = read_number(node.items[2], scope);
  if (!x || !y || !z) return std::nullopt;
  return Vec3(*x, *y, *z);
}

std::optional<Vec3> read_point(const Node& node, Scope& scope) {
  if (node.kind != Node::Kind::scalar) return read_vector(node, scope);
  return look_up(scope.points, node, "point", "points", scope.findings);
}

std::optional<std::vector<Vec3>> read_points(const Node& node, Scope& scope) {
  if (node.kind != Node::Kind::list) {
    scope.findings.error(node.where, fmt::format("a list of points belongs here, not {}", describe(node)));
    return std::nullopt;
  }
  std::vector<Vec3> points;
  for (const Node& item : node.items) {
    if (const std::optional<Vec3> point = read_point(item, scope)) points.push_back(*point);
  }
  if (points.size() < node.items.size()) return std::nullopt;
  return points;
}

std::optional<Vec3> read_axis(const Node& node, Scope& scope) {
  if (node.kind == Node::Kind::scalar) {
    const bool negative = node.text.starts_with('-');
    const std::string_view letter =
        std::string_view(node.text).substr(negative || node.text.starts_with('+') ? 1 : 0);
    const std::size_t index =
        letter.size() == 1 ? std::string_view("xyz").find(letter[0]) : std::string_view::npos;
    if (index != std::string_view::npos)
      return (negative ? -1.0 : 1.0) * Vec3::Unit(static_cast<Eigen::Index>(index));
    scope.findings.error(
        node.where, fmt::format("'{}' is not an axis; write x, y, z, -x, -y, -z or [x, y, z]", node.text));
    return std::nullopt;
  }
  const std::optional<Vec3> vector = read_vector(node, scope);
  if (!vector) return std::nullopt;
  const double largest = vector->cwiseAbs().maxCoeff();
  if (largest == 0) {
    scope.findings.error(node.where, "the axis [0, 0, 0] has no direction");
    return std::nullopt;
  }
  return (*vector / largest).normalized();  // first scaled, so that tiny vectors keep their digits
}

}  // namespace flexkey
