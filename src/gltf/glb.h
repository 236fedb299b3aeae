#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tinygltf {
class Model;
}

namespace flexkey {

/// A glTF asset as a GLB holds it.
struct Glb {
  std::string json;                  // the text of the JSON chunk
  std::vector<unsigned char> bytes;  // the binary chunk: buffer 0
};

/// The model's buffer 0, its only one, becomes the binary chunk.
Glb glb_of(tinygltf::Model&& model);

/// Hands the file's bytes over, piece by piece. Throws InputError where it would reach 4 GiB.
void put_glb(const Glb& glb, const std::function<void(std::string_view)>& put);

/// Writes a GLB, which appears under its name only when whole. Returns its bytes.
/// Throws OutputError where the file cannot be written, and InputError where it would reach 4 GiB.
std::uintmax_t save_glb(const Glb& glb, const std::filesystem::path& path);

}  // namespace flexkey
