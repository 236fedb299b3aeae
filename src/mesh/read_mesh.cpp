#include "flexkey/mesh/read_mesh.h"

#include <fmt/format.h>

#include <cctype>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/obj.h"

namespace flexkey {

MeshFile read_mesh(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension != ".obj")
    throw InputError(
        fmt::format("cannot read '{}': meshes are read from .obj, .glb and .gltf files", path.string()));
  return read_obj(path);
}

}  // namespace flexkey
