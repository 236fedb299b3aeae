#include "cli/mesh_input.h"

#include <cctype>
#include <utility>

#include "flexkey/mesh/read_mesh.h"

namespace flexkey::cli {

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

MeshInput read_mesh_input(const std::filesystem::path& path, const std::vector<std::string>& nodes) {
  const std::string extension = lower_extension(path);
  if (extension != ".glb" && extension != ".gltf") return {read_mesh(path), std::nullopt};
  GltfFile file = read_gltf(path, nodes);
  return {std::move(file.file), std::move(file.source)};
}

}  // namespace flexkey::cli
