#include "flexkey/gltf/choose_nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "flexkey/gltf/read_gltf.h"
#include "flexkey/mesh/spelling.h"

namespace flexkey {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// Whether there is something of it to solve.
bool has_mesh(const GltfScene& scene, int node) {
  const int mesh = scene.nodes[index(node)].mesh;
  return mesh >= 0 && !scene.meshes[index(mesh)].primitives.empty();
}

/// The nodes in question that have a mesh.
std::set<int> with_meshes(const GltfScene& scene, const std::vector<int>& nodes) {
  std::set<int> found;
  for (const int node : nodes)
    if (has_mesh(scene, node)) found.insert(node);
  return found;
}

std::set<int> nodes_named(const GltfScene& scene, const NodeTree& tree, const std::string& name) {
  std::set<int> found;
  for (int node = 0; node < static_cast<int>(scene.nodes.size()); ++node) {
    if (scene.nodes[index(node)].name == name || (has_mesh(scene, node) && node_name(scene, node) == name))
      found.merge(with_meshes(scene, has_mesh(scene, node) ? std::vector{node} : tree.subtree(node)));
  }
  return found;
}

std::set<int> nodes_of_default_scene(const GltfScene& scene, const NodeTree& tree) {
  std::set<int> found;
  const std::size_t chosen = index(std::max(scene.scene, 0));
  if (chosen < scene.scenes.size()) {
    for (const int root : scene.scenes[chosen]) found.merge(with_meshes(scene, tree.subtree(root)));
  } else {
    for (int node = 0; node < static_cast<int>(scene.nodes.size()); ++node)
      found.merge(with_meshes(scene, {node}));
  }
  return found;
}

std::vector<std::string> names_of(const GltfScene& scene, const std::set<int>& nodes) {
  std::vector<std::string> names;
  for (const int node : nodes) names.push_back(node_name(scene, node));
  return names;
}

}  // namespace

std::vector<int> choose_nodes(const GltfScene& scene, const NodeTree& tree, const NodeChoice& choice) {
  const std::set<int> all = nodes_of_default_scene(scene, tree);
  std::set<int> chosen;
  for (std::size_t which = 0; which < choice.names.size(); ++which) {
    const std::string& name = choice.names[which];
    std::set<int> named = nodes_named(scene, tree, name);
    if (named.empty())
      throw UnknownNodeError(which, no_such_name("node", name, choice.file, names_of(scene, all)));
    chosen.merge(std::move(named));
  }
  if (choice.names.empty()) chosen = all;
  if (chosen.empty()) throw InputError("no node of its scene shows a mesh");
  return {chosen.begin(), chosen.end()};
}

}  // namespace flexkey
