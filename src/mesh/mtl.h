#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// The materials of an MTL library: diffuse colour, opacity and colour texture. Throws InputError.
std::vector<Material> read_mtl(const std::filesystem::path& path);

/// The same from a text.
std::vector<Material> parse_mtl(const std::string& bytes);

}  // namespace flexkey
