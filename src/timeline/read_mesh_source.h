#pragma once

#include "flexkey/timeline/scope.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// `mesh`: a path, `scene.glb#Node`, or {file, nodes, loose, weld}.
MeshSource read_mesh_source(const Node& node, Scope& scope);

}  // namespace flexkey
