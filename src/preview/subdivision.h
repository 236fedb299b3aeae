#pragma once

#include <memory>
#include <string>
#include <vector>

#include "flexkey/mesh/mesh.h"
#include "flexkey/preview/surface.h"

namespace flexkey {

/// Rows of weights over control vertices, one a refined vertex: refined = weights * control.
struct Stencils {
  std::vector<int> offsets;    // #refined + 1
  std::vector<int> vertices;   // control vertex of each weight
  std::vector<float> weights;  // a row's sum is 1
};

/// The refined points: #refined x 3, of control points #control x 3. The cost of a frame.
Points apply(const Stencils& stencils, const Points& control);

/// A mesh's subdivision surface at a level: topology and stencils once, then one cheap apply a frame.
/// Catmull-Clark for polygons, Loop where all faces are triangles. Borders and their corners stay, creases
/// and sharp vertices as far as the mesh says, texture seams are closed in space, and texture coordinates are
/// interpolated on each side of a seam.
class Subdivision {
 public:
  /// level: 0 (the polygons, triangulated) .. 4; vertices at most `weld` apart are one. A mesh that no scheme
  /// takes stays at level 0 and says why in `warning`.
  /// Throws InputError for another level, or where the level makes more triangles than can be drawn.
  Subdivision(const Mesh& mesh, int level, double weld = 0);

  const Surface& surface() const { return surface_; }
  const std::string& warning() const { return warning_; }  // empty: none

  /// Vertices of the file that the control points are taken from, #control.
  const std::vector<int>& control_vertices() const { return control_vertices_; }

  /// control: #control x 3, the places of `control_vertices`.
  Points points(const Points& control) const { return apply(stencils_, control); }

 private:
  std::vector<int> control_vertices_;
  Stencils stencils_;
  Surface surface_;
  std::string warning_;
};

}  // namespace flexkey
