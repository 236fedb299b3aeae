#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "flexkey/mesh/mesh_file.h"

namespace flexkey {

/// Reads an OFF: polygons as they are. Normals, colours and texture coordinates (NOFF, COFF, STOFF and their
/// like) are passed over. Throws InputError with file and line for what is not a mesh of three dimensions.
MeshFile read_off(const std::filesystem::path& path);

/// The same from a text; `name` stands in messages.
MeshFile parse_off(std::string_view text, const std::string& name);

}  // namespace flexkey
