#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/types.h"

namespace flexkey {

/// A place in a timeline file, both counted from 1; line 0 means "nowhere in the file".
struct Mark {
  int line = 0;
  int column = 0;
};

/// A length in mesh units, or a share (0.01 is 1%) of a reference length that its user names.
struct Length {
  double value = 0;
  bool is_share = false;
  double resolve(double reference) const { return is_share ? value * reference : value; }
};

/// What a timeline says of a set of vertices, as a tree of values; see `select_vertices`.
struct Selection;

struct IndexRange {
  int first = 0, last = 0;  // file vertex indices from 0, both included
};
struct SelectVertices {
  std::vector<IndexRange> ranges;
};
struct SelectGroup {
  std::string name;
};
struct SelectMaterial {
  std::string name;
};
struct SelectNode {
  std::string name;  // a node of the file that is solved; it is a group of the mesh
};
struct SelectSphere {
  Vec3 center;
  Length radius;  // share of the bounding-box diagonal
};
struct SelectBox {
  Vec3 min, max;
};
struct SelectPlane {
  Vec3 point, normal;
  Length within;  // largest distance from the plane; share of the diagonal
};
struct SelectAxis {
  int axis = 0;                        // 0 x, 1 y, 2 z
  std::optional<Length> above, below;  // share: of the extent along the axis, from its low end
};
struct SelectNearest {
  Vec3 point;
};
struct SelectGeodesic {
  Vec3 from;      // snapped to the nearest vertex
  Length radius;  // along the surface; share of the diagonal
};
struct SelectPath {
  std::vector<Vec3> points;  // snapped to the nearest vertices, joined by shortest edge chains
};
struct SelectBoundary {
  bool all = false;  // false: the longest loop only
};
struct SelectAttribute {
  std::string name;                    // of a custom vertex attribute of a glTF file, "_MASK"
  std::optional<Length> above, below;  // share: of the range of its values, from the least
};
struct SelectComponent {
  int index = 0;  // components are numbered by their lowest vertex
};
struct SelectAny {
  std::vector<Selection> of;
};
struct SelectAll {
  std::vector<Selection> of;
};
struct SelectNot {
  std::vector<Selection> of;  // exactly one
};

struct Selection {
  std::variant<SelectVertices, SelectGroup, SelectMaterial, SelectNode, SelectSphere, SelectBox, SelectPlane,
               SelectAxis, SelectNearest, SelectGeodesic, SelectPath, SelectBoundary, SelectAttribute,
               SelectComponent, SelectAny, SelectAll, SelectNot>
      kind;
  int grow = 0;  // rings of neighbours added last
  Mark where;    // of the value of the kind's key, for messages
};

/// A selection that names nothing of this mesh, or takes no vertex.
class SelectionError : public Error {
 public:
  SelectionError(Mark where, const std::string& message) : Error(message), where_(where) {}
  Mark where() const { return where_; }

 private:
  Mark where_;
};

}  // namespace flexkey
