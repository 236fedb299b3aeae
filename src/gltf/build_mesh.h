#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "flexkey/gltf/gltf_scene.h"
#include "flexkey/gltf/node_tree.h"
#include "flexkey/gltf/read_gltf.h"

namespace flexkey {

/// The meshes of these nodes as one, with what leads back to them but without the document.
/// Throws InputError for what cannot be read or solved, naming the primitive, node or accessor.
GltfFile build_mesh(const GltfScene& scene, const NodeTree& tree, const std::vector<int>& nodes,
                    std::span<const unsigned char> bytes);

}  // namespace flexkey
