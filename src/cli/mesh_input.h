#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "flexkey/gltf/read_gltf.h"
#include "flexkey/mesh/mesh_file.h"

namespace flexkey::cli {

/// A mesh as read from disk, of any format that flexkey reads.
struct MeshInput {
  MeshFile file;
  std::optional<GltfSource> source;  // where it is of a glTF file
};

/// ".glb" of "Scene.GLB".
std::string lower_extension(const std::filesystem::path& path);

/// By the path's extension. nodes: of a glTF file; empty: all. Throws InputError, UnknownNodeError.
MeshInput read_mesh_input(const std::filesystem::path& path, const std::vector<std::string>& nodes = {});

}  // namespace flexkey::cli
