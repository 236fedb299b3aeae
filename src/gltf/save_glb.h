#pragma once

#include <cstdint>
#include <filesystem>

namespace tinygltf {
class Model;
}

namespace flexkey {

/// Writes the model as a GLB, which appears under its name only when whole. Returns its bytes.
/// Throws OutputError where the file cannot be written, and InputError where it grew beyond 4 GiB.
std::uintmax_t save_glb(const tinygltf::Model& model, const std::filesystem::path& path);

}  // namespace flexkey
