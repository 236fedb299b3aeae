#include "flexkey/gltf/read_gltf.h"

#include <fmt/format.h>

#include "flexkey/gltf/build_mesh.h"
#include "flexkey/gltf/choose_nodes.h"
#include "flexkey/gltf/gather_buffers.h"
#include "flexkey/gltf/gltf_scene.h"
#include "flexkey/gltf/node_tree.h"
#include "flexkey/gltf/split_container.h"
#include "flexkey/mesh/read_file.h"

namespace flexkey {
namespace {

GltfFile parse(const std::string& file, const std::filesystem::path& path,
               const std::vector<std::string>& names) {
  Gathered gathered = gather_buffers(split_container(file), path.parent_path());
  const GltfScene scene = parse_gltf_scene(gathered.document.json);
  const NodeTree tree(scene);
  const std::vector<int> nodes = choose_nodes(scene, tree, {names, path.filename().string()});
  GltfFile result = build_mesh(scene, tree, nodes, gathered.document.bytes);
  result.source.document = std::move(gathered.document);
  result.file.inputs = std::move(gathered.inputs);
  for (std::string& warning : gathered.warnings) result.file.warnings.push_back(std::move(warning));
  for (std::string& warning : result.file.warnings) warning = fmt::format("{}: {}", path.string(), warning);
  return result;
}

}  // namespace

GltfFile read_gltf(const std::filesystem::path& path, const std::vector<std::string>& names) {
  return parse_gltf(read_file(path), path, names);
}

GltfFile parse_gltf(const std::string& file, const std::filesystem::path& path,
                    const std::vector<std::string>& names) {
  try {
    return parse(file, path, names);
  } catch (const UnknownNodeError&) {
    throw;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", path.string(), error.what()));
  }
}

}  // namespace flexkey
