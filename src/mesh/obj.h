#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "flexkey/mesh/limits.h"
#include "flexkey/mesh/mesh_file.h"

namespace flexkey {

/// Reads an OBJ with its material libraries: polygons, all index forms, `g` and `o` as groups, `usemtl`, and
/// OpenSubdiv's tags `t crease` and `t corner` (see obj_tags.h).
/// Lines, points, free-form surfaces and the file's normals are passed over.
/// Throws InputError with file and line for what is not a mesh (an index out of range, a coordinate that is
/// not a finite number), and for a file that cannot be read.
MeshFile read_obj(const std::filesystem::path& path);

/// The same from a text; `name` stands in messages, material libraries are looked for in `folder`. What is
/// larger than `most` is refused.
MeshFile parse_obj(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                   const limits::MeshSize& most = {});

}  // namespace flexkey
