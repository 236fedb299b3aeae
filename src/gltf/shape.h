#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "flexkey/gltf/float_rows.h"
#include "flexkey/mesh/mesh.h"
#include "flexkey/mesh/weld.h"

namespace flexkey {

/// Normals at positions of all vertices of a mesh, #V x 3.
using NormalsAt = std::function<Positions(const Positions&)>;

/// One pose of the mesh as glTF stores it, a row a file vertex.
struct Shape {
  FloatRows positions;  // #V x 3
  FloatRows normals;    // #V x 3, unit vectors; no rows without normals
};

/// Normals of the surface welded by position, so that UV and material seams shade smoothly.
class SeamlessNormals {
 public:
  explicit SeamlessNormals(const Mesh& mesh);
  /// Unit normals at these positions of the file's vertices, #V x 3.
  Positions at(const Positions& positions) const;

 private:
  Weld weld_;
  std::vector<int> first_;  // #surface vertices, the first file vertex of each
};

/// The mesh at these positions, rounded to floats; with normals where they are given.
Shape shape_at(const Positions& positions, const std::optional<SeamlessNormals>& normals);

}  // namespace flexkey
