#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "flexkey/gltf/glb.h"

namespace flexkey {

/// A document whose views are all of buffer 0.
struct Gathered {
  Glb document;
  std::vector<std::filesystem::path> inputs;  // files that were read
  std::vector<std::string> warnings;          // images that are missing
};

/// Makes a document whole: its buffers, whether the GLB's own, data URIs or files in `folder`, become one;
/// views of EXT_meshopt_compression are decoded; images become views of it too, or stay as they are with a
/// warning where they cannot be read. Every view lies within the bytes. Throws InputError that names the
/// buffer or view: missing, shorter than it says, out of bounds.
Gathered gather_buffers(const Glb& document, const std::filesystem::path& folder);

}  // namespace flexkey
