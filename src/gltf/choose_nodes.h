#pragma once

#include <string>
#include <vector>

#include "flexkey/gltf/gltf_scene.h"
#include "flexkey/gltf/node_tree.h"

namespace flexkey {

/// What a user asks for of a file.
struct NodeChoice {
  std::vector<std::string> names;  // none: all nodes of the default scene
  std::string file;                // its name, for messages
};

/// The nodes with meshes that are meant, see read_gltf; increasing, at least one. Throws InputError where
/// there is none, UnknownNodeError for a name.
std::vector<int> choose_nodes(const GltfScene& scene, const NodeTree& tree, const NodeChoice& choice);

}  // namespace flexkey
