#pragma once

#include <vector>

#include "flexkey/gltf/asset.h"
#include "flexkey/gltf/split_note.h"

namespace flexkey {

/// The meshes of a new file.
struct AssetSplit {
  std::vector<Primitive> moving;  // of mesh 0, which has targets
  std::vector<Primitive> still;   // of mesh 1, which has none; empty: there is no such mesh
  SplitNote note;
};

/// All in one mesh.
AssetSplit whole(const Asset& asset);

/// Faces that never move in a mesh of their own, where that is worth it. moved: see moved_vertices.
AssetSplit split_asset(const Asset& asset, const std::vector<bool>& moved);

}  // namespace flexkey
