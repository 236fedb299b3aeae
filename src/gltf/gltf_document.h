#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace flexkey {

/// A glTF file as a GLB holds it: its JSON and one binary chunk, which is buffer 0.
struct GltfDocument {
  std::string json;
  std::vector<std::byte> bytes;
};

/// Takes a .glb or .gltf file apart, told by its content. Only its framing is checked: chunks that end before
/// the file does, versions, JSON that can be read and is nested at most 100 deep.
/// Throws InputError.
GltfDocument split_container(std::string_view file);

}  // namespace flexkey
