#include "flexkey/gltf/node_tree.h"

#include <fmt/format.h>

#include <algorithm>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

std::vector<int> parents_of(const GltfScene& scene) {
  std::vector<int> parents(scene.nodes.size(), -1);
  for (std::size_t node = 0; node < scene.nodes.size(); ++node)
    for (const int child : scene.nodes[node].children) {
      int& parent = parents[index(child)];
      if (parent >= 0)
        throw InputError(fmt::format("node {} is a child of node {} and of node {}", child, parent, node));
      parent = static_cast<int>(node);
    }
  return parents;
}

}  // namespace

NodeTree::NodeTree(const GltfScene& scene) : scene_(scene) {
  const std::vector<int> parents = parents_of(scene);
  worlds_.resize(scene.nodes.size());
  std::vector<bool> reached(scene.nodes.size(), false);
  for (std::size_t root = 0; root < parents.size(); ++root) {
    if (parents[root] >= 0) continue;
    for (const int node : subtree(static_cast<int>(root))) {
      const int parent = parents[index(node)];
      const Eigen::Matrix4d& local = scene.nodes[index(node)].local;
      worlds_[index(node)] = parent < 0 ? local : Eigen::Matrix4d(worlds_[index(parent)] * local);
      reached[index(node)] = true;
    }
  }
  const auto lost = std::find(reached.begin(), reached.end(), false);
  if (lost != reached.end())
    throw InputError(
        fmt::format("the nodes run in a circle: node {} is above itself", lost - reached.begin()));
}

std::vector<int> NodeTree::subtree(int node) const {
  std::vector<int> nodes{node};
  for (std::size_t at = 0; at < nodes.size(); ++at) {
    const std::vector<int>& children = scene_.nodes[index(nodes[at])].children;
    nodes.insert(nodes.end(), children.begin(), children.end());
  }
  return nodes;
}

std::string node_name(const GltfScene& scene, int node) {
  const GltfNode& named = scene.nodes[index(node)];
  if (!named.name.empty()) return named.name;
  if (named.mesh >= 0 && !scene.meshes[index(named.mesh)].name.empty())
    return scene.meshes[index(named.mesh)].name;
  return fmt::format("node {}", node);
}

}  // namespace flexkey
