#pragma once

#include <filesystem>
#include <vector>

#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// The materials of an MTL library: diffuse colour, opacity and colour texture. Throws InputError.
std::vector<Material> read_mtl(const std::filesystem::path& path);

}  // namespace flexkey
