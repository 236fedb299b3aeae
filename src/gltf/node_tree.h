#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "flexkey/gltf/gltf_scene.h"

namespace flexkey {

/// The nodes of a scene as the forest that they must be.
class NodeTree {
 public:
  /// Throws InputError for a node with two parents and for a cycle.
  explicit NodeTree(const GltfScene& scene);

  /// From a node's space to the scene's.
  const Eigen::Matrix4d& world(int node) const { return worlds_[static_cast<std::size_t>(node)]; }

  /// The node and all below it.
  std::vector<int> subtree(int node) const;

 private:
  const GltfScene& scene_;
  std::vector<Eigen::Matrix4d> worlds_;
};

/// What a node is called: its name, else its mesh's, else "node 3".
std::string node_name(const GltfScene& scene, int node);

}  // namespace flexkey
