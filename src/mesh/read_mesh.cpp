#include "flexkey/mesh/read_mesh.h"

#include <fmt/format.h>

#include <cctype>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/obj.h"
#include "flexkey/mesh/off.h"
#include "flexkey/mesh/ply.h"
#include "flexkey/mesh/stl.h"

namespace flexkey {

MeshFile read_mesh(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".obj") return read_obj(path);
  if (extension == ".off") return read_off(path);
  if (extension == ".ply") return read_ply(path);
  if (extension == ".stl") return read_stl(path);
  throw InputError(fmt::format(
      "cannot read '{}': meshes are read from .obj, .ply, .off, .stl, .glb and .gltf files", path.string()));
}

}  // namespace flexkey
