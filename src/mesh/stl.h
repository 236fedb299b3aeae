#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "flexkey/mesh/mesh_file.h"

namespace flexkey {

/// Reads an STL, binary or text. Its triangles name no vertices: corners at the same place become one vertex,
/// numbered as they first appear. Named solids of a text are groups; normals are passed over.
/// Throws InputError with file and line, or byte, for what is not a mesh.
MeshFile read_stl(const std::filesystem::path& path);

/// The same from the file's bytes; `name` stands in messages.
MeshFile parse_stl(std::string_view bytes, const std::string& name);

}  // namespace flexkey
