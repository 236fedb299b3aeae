#pragma once

#include "flexkey/timeline/scope.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// `mesh`: a path, or {file, loose, weld}.
MeshSource read_mesh_source(const Node& node, Scope& scope);

/// `output`: a path, or {gltf: a path or a mapping}. Without `gltf` the result has no path.
GltfOutput read_output(const Node& node, Scope& scope);

}  // namespace flexkey
