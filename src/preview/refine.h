#pragma once

#include "flexkey/preview/control_mesh.h"
#include "flexkey/preview/subdivision.h"

namespace flexkey {

/// What OpenSubdiv makes of a control mesh.
struct Refined {
  Stencils stencils;
  Surface surface;
};

/// Refines uniformly to `level` >= 1 by Catmull-Clark, or by Loop where all faces are triangles. `source` is
/// the file's mesh, for its texture coordinates.
Refined refine(const ControlMesh& control, const Mesh& source, int level);

}  // namespace flexkey
