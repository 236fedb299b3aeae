#pragma once

#include <filesystem>

#include "flexkey/mesh/mesh_file.h"

namespace flexkey {

/// Reads a mesh by its file name's extension, .obj, .ply, .off or .stl; `read_gltf` reads scenes. Throws
/// InputError.
MeshFile read_mesh(const std::filesystem::path& path);

}  // namespace flexkey
