#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "flexkey/gltf/primitives.h"
#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// An image file as it is, not decoded.
struct Texture {
  std::string name;
  std::string mime_type;  // "image/png" or "image/jpeg", by its first bytes
  std::vector<std::byte> bytes;
};

/// The base colour images of the primitives' materials.
struct TextureSet {
  std::vector<Texture> textures;      // each file once
  std::vector<int> of_primitive;      // #primitives, index of textures or -1
  std::vector<std::string> warnings;  // what was left out and why
};

/// Reads the images that the primitives' materials name, from `folder` where their paths are relative. One
/// that is missing, too large, neither PNG nor JPEG, or on faces without texture coordinates is left out with
/// a warning.
TextureSet read_textures(const Mesh& mesh, const std::vector<Primitive>& primitives,
                         const std::filesystem::path& folder);

}  // namespace flexkey
