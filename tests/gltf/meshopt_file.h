#pragma once

#include <tiny_gltf.h>

#include <filesystem>

namespace flexkey::testing {

/// Reads a GLB whose buffer views may be encoded by EXT_meshopt_compression, and decodes them with
/// meshoptimizer into buffer 1, as a client does. Throws std::runtime_error for a view that cannot be
/// decoded.
tinygltf::Model load_meshopt_glb(const std::filesystem::path& path);

}  // namespace flexkey::testing
