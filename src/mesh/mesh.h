#pragma once

#include <span>
#include <string>
#include <vector>

#include "flexkey/mesh/types.h"

namespace flexkey {

/// A named set of faces: an OBJ `g` or `o`.
struct Group {
  std::string name;
  std::vector<int> faces;  // face indices, increasing
};

/// A number a vertex, as glTF's custom attributes have it.
struct Attribute {
  std::string name;        // "_MASK"
  Eigen::VectorXd values;  // #V, NaN where the file says nothing
};

/// What an OBJ material says that glTF can say too.
struct Material {
  std::string name;
  Vec3 base_color{0.8, 0.8, 0.8};  // sRGB as the file gives it, 0..1
  double opacity = 1.0;            // 0..1
  std::string texture;             // path of the base colour image as the file gives it, or empty
};

/// The sharpness from which on a crease stays sharp at every level of subdivision.
constexpr double infinitely_sharp = 10;

/// An edge that subdivision keeps sharp for as many levels as its sharpness says.
struct Crease {
  int from = 0, to = 0;  // vertices
  double sharpness = 0;  // 0 smooth .. 10 infinitely sharp
};

/// A vertex that does likewise.
struct SharpVertex {
  int vertex = 0;
  double sharpness = 0;
};

/// A polygon mesh as its file has it: polygons stay polygons and vertices keep their order.
struct Mesh {
  Positions positions;            // #V x 3, file units
  std::vector<int> face_offsets;  // #F + 1; face f has the corners [face_offsets[f], face_offsets[f + 1])
  std::vector<int> corners;       // #corners, vertex index a corner, counter-clockwise seen from outside

  TexCoords texcoords;               // #T x 2, possibly empty
  std::vector<int> corner_texcoord;  // #corners, row of texcoords or -1; empty where the file has none

  std::vector<Material> materials;
  std::vector<int> face_material;  // #F, index of materials or -1; empty where the file has none
  std::vector<Group> groups;
  std::vector<Attribute> attributes;

  std::vector<Crease> creases;  // of the polygons' edges; of one that is there twice the last holds
  std::vector<SharpVertex> sharp_vertices;

  int vertex_count() const { return static_cast<int>(positions.rows()); }
  int face_count() const { return face_offsets.empty() ? 0 : static_cast<int>(face_offsets.size()) - 1; }

  /// Vertex indices around face f.
  std::span<const int> face(int f) const {
    const auto first = static_cast<std::size_t>(face_offsets[static_cast<std::size_t>(f)]);
    const auto last = static_cast<std::size_t>(face_offsets[static_cast<std::size_t>(f) + 1]);
    return {corners.data() + first, last - first};
  }

  /// Appends a face of these vertices.
  void add_face(std::span<const int> vertices);
};

/// Axis-aligned bounds of all rows; an empty matrix gives zeros.
struct Bounds {
  Vec3 min = Vec3::Zero();
  Vec3 max = Vec3::Zero();
  double diagonal() const { return (max - min).norm(); }
};
Bounds bounds_of(const Positions& positions);

/// Area-weighted unit vertex normals of the polygons at the given positions, #V x 3; a vertex without area
/// gets +y. A polygon's area vector is half the sum of the cross products around it, whatever its corner
/// count.
Positions vertex_normals(const Mesh& mesh, const Positions& positions);

}  // namespace flexkey
