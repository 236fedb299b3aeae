#include "flexkey/timeline/selection_kinds.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "flexkey/timeline/read_vertices.h"
#include "flexkey/timeline/scalar.h"
#include "flexkey/timeline/vector.h"
#include "flexkey/timeline/words.h"

namespace flexkey {
namespace {

std::optional<std::string> read_name(const KindNode& kind, Scope& scope) {
  if (kind.value.kind == Node::Kind::scalar) return kind.value.text;
  scope.findings.error(kind.value.where,
                       fmt::format("{} takes one name, not {}", kind.place, describe(kind.value)));
  return std::nullopt;
}

MaybeKind read_group(const KindNode& kind, Scope& scope) {
  const std::optional<std::string> name = read_name(kind, scope);
  return name ? MaybeKind(SelectGroup{*name}) : std::nullopt;
}

MaybeKind read_material(const KindNode& kind, Scope& scope) {
  const std::optional<std::string> name = read_name(kind, scope);
  return name ? MaybeKind(SelectMaterial{*name}) : std::nullopt;
}

MaybeKind read_node(const KindNode& kind, Scope& scope) {
  const std::optional<std::string> name = read_name(kind, scope);
  return name ? MaybeKind(SelectNode{*name}) : std::nullopt;
}

MaybeKind read_vertices(const KindNode& kind, Scope& scope) {
  std::optional<std::vector<IndexRange>> ranges = read_index_ranges(kind.value, scope);
  return ranges ? MaybeKind(SelectVertices{std::move(*ranges)}) : std::nullopt;
}

/// The two values of a kind that is a mapping of two keys, such as {center, radius}.
struct TwoNodes {
  const Node* first = nullptr;
  const Node* second = nullptr;
};

TwoNodes read_two(const KindNode& kind, const MappingSpec& spec, Scope& scope) {
  const std::optional<Fields> fields = read_fields(kind.value, spec, kind.place, scope.findings);
  if (!fields) return {};
  return {require(*fields, spec.keys[0].name, kind.value.where, kind.place, scope.findings),
          require(*fields, spec.keys[1].name, kind.value.where, kind.place, scope.findings)};
}

std::optional<Vec3> read_point_if(const Node* node, Scope& scope) {
  return node != nullptr ? read_point(*node, scope) : std::nullopt;
}

std::optional<Length> read_distance_if(const Node* node, Scope& scope) {
  return node != nullptr ? read_distance(*node, scope) : std::nullopt;
}

MaybeKind read_sphere(const KindNode& kind, Scope& scope) {
  const TwoNodes nodes = read_two(kind, sphere_keys, scope);
  const std::optional<Vec3> center = read_point_if(nodes.first, scope);
  const std::optional<Length> radius = read_distance_if(nodes.second, scope);
  if (!center || !radius) return std::nullopt;
  return SelectSphere{*center, *radius};
}

MaybeKind read_geodesic(const KindNode& kind, Scope& scope) {
  const TwoNodes nodes = read_two(kind, geodesic_keys, scope);
  const std::optional<Vec3> from = read_point_if(nodes.first, scope);
  const std::optional<Length> radius = read_distance_if(nodes.second, scope);
  if (!from || !radius) return std::nullopt;
  return SelectGeodesic{*from, *radius};
}

MaybeKind read_box(const KindNode& kind, Scope& scope) {
  const TwoNodes nodes = read_two(kind, box_keys, scope);
  const std::optional<Vec3> min = read_point_if(nodes.first, scope);
  const std::optional<Vec3> max = read_point_if(nodes.second, scope);
  if (!min || !max) return std::nullopt;
  for (Eigen::Index i = 0; i < 3; ++i) {
    if ((*min)[i] <= (*max)[i]) continue;
    scope.findings.error(kind.value.where, fmt::format("the box's min is above its max along {}", "xyz"[i]));
    return std::nullopt;
  }
  return SelectBox{*min, *max};
}

MaybeKind read_plane(const KindNode& kind, Scope& scope) {
  const std::optional<Fields> fields = read_fields(kind.value, plane_keys, kind.place, scope.findings);
  if (!fields) return std::nullopt;
  const auto get = [&](std::string_view key) {
    return require(*fields, key, kind.value.where, kind.place, scope.findings);
  };
  const std::optional<Vec3> point = read_point_if(get("point"), scope);
  const Node* normal_node = get("normal");
  const std::optional<Vec3> normal = normal_node != nullptr ? read_axis(*normal_node, scope) : std::nullopt;
  const std::optional<Length> within = read_distance_if(get("within"), scope);
  if (!point || !normal || !within) return std::nullopt;
  return SelectPlane{*point, *normal, *within};
}

std::optional<int> read_axis_letter(const Node& node, Scope& scope) {
  for (int axis = 0; axis < 3; ++axis) {
    if (node.kind == Node::Kind::scalar &&
        node.text == std::string_view("xyz").substr(static_cast<std::size_t>(axis), 1)) {
      return axis;
    }
  }
  scope.findings.error(node.where,
                       fmt::format("the axis of a selection is x, y or z, not {}", describe(node)));
  return std::nullopt;
}

/// `above` and `below` of a kind that has them beside it; whether they can be read, and one is there.
template <class Bounded>
bool read_bounds(const KindNode& kind, Bounded& result, Scope& scope) {
  if (kind.fields.lacks("above") && kind.fields.lacks("below")) {
    scope.findings.error(kind.value.where, fmt::format("{} needs 'above' or 'below' beside it", kind.place));
    return false;
  }
  const Node *above = kind.fields.value("above"), *below = kind.fields.value("below");
  if (above != nullptr) result.above = read_length(*above, scope);
  if (below != nullptr) result.below = read_length(*below, scope);
  return (above == nullptr || result.above) && (below == nullptr || result.below);
}

MaybeKind read_axis_kind(const KindNode& kind, Scope& scope) {
  SelectAxis result;
  const std::optional<int> axis = read_axis_letter(kind.value, scope);
  result.axis = axis.value_or(0);
  const bool is_bounded = read_bounds(kind, result, scope);
  return axis && is_bounded ? MaybeKind(result) : std::nullopt;
}

MaybeKind read_attribute(const KindNode& kind, Scope& scope) {
  SelectAttribute result;
  const std::optional<std::string> name = read_name(kind, scope);
  result.name = name.value_or("");
  if (name && !name->starts_with('_')) {
    scope.findings.error(kind.value.where, fmt::format("'{}' is no custom attribute of glTF, whose names "
                                                       "begin with '_'",
                                                       *name));
    return std::nullopt;
  }
  const bool is_bounded = read_bounds(kind, result, scope);
  return name && is_bounded ? MaybeKind(result) : std::nullopt;
}

MaybeKind read_nearest(const KindNode& kind, Scope& scope) {
  const std::optional<Vec3> point = read_point(kind.value, scope);
  return point ? MaybeKind(SelectNearest{*point}) : std::nullopt;
}

MaybeKind read_path(const KindNode& kind, Scope& scope) {
  std::optional<std::vector<Vec3>> points;
  if (kind.value.kind == Node::Kind::scalar) {
    const std::optional<Curve> curve = look_up(scope.paths, kind.value, "path", "paths", scope.findings);
    if (curve) points = curve->points;
  } else {
    points = read_points(kind.value, scope);
  }
  if (!points) return std::nullopt;
  if (points->size() < 2) {
    scope.findings.error(kind.value.where,
                         fmt::format("a path selection has at least 2 points, not {}", points->size()));
    return std::nullopt;
  }
  return SelectPath{std::move(*points)};
}

MaybeKind read_boundary(const KindNode& kind, Scope& scope) {
  const std::optional<bool> all =
      read_word<bool>(kind.value, "boundary", {{"longest", false}, {"all", true}}, scope);
  return all ? MaybeKind(SelectBoundary{*all}) : std::nullopt;
}

MaybeKind read_component(const KindNode& kind, Scope& scope) {
  const std::optional<int> index = read_whole(kind.value, scope);
  if (!index) return std::nullopt;
  if (*index >= 0) return SelectComponent{*index};
  scope.findings.error(kind.value.where, "components are counted from 0");
  return std::nullopt;
}

struct KindReader {
  std::string_view name;
  MaybeKind (*read)(const KindNode&, Scope&);
};

constexpr std::array<KindReader, 13> kind_readers = {{
    {"vertices", read_vertices},
    {"group", read_group},
    {"material", read_material},
    {"node", read_node},
    {"sphere", read_sphere},
    {"box", read_box},
    {"plane", read_plane},
    {"axis", read_axis_kind},
    {"nearest", read_nearest},
    {"geodesic", read_geodesic},
    {"path", read_path},
    {"boundary", read_boundary},
    {"attribute", read_attribute},
}};

}  // namespace

MaybeKind read_simple_kind(std::string_view name, const KindNode& kind, Scope& scope) {
  for (const KindReader& reader : kind_readers) {
    if (reader.name == name) return reader.read(kind, scope);
  }
  return read_component(kind, scope);
}

}  // namespace flexkey
