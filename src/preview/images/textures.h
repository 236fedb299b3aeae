#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "flexkey/mesh/mesh.h"
#include "flexkey/preview/render_options.h"

namespace flexkey {

/// The base colour images of a mesh's materials.
struct Textures {
  TextureLookup lookup;               // for RenderOptions::texture
  std::vector<std::string> warnings;  // of images that cannot be read; their materials keep their colour
};

/// Reads each image once, from `folder`. Throws OutputError if there is no module for pictures.
Textures load_textures(const Mesh& mesh, const std::filesystem::path& folder);

}  // namespace flexkey
