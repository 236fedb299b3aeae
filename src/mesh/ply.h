#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "flexkey/mesh/mesh_file.h"

namespace flexkey {

/// Reads a PLY, text or binary of either byte order: polygons as they are, texture coordinates of vertices
/// (s t, u v or texture_u texture_v) or of corners (the list texcoord). Normals, colours and other properties
/// are passed over, other elements likewise and with a warning.
/// Throws InputError with file and line, or byte, for what is not a mesh.
MeshFile read_ply(const std::filesystem::path& path);

/// The same from the file's bytes; `name` stands in messages.
MeshFile parse_ply(std::string_view bytes, const std::string& name);

}  // namespace flexkey
