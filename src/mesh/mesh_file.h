#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// What a reader makes of a file.
struct MeshFile {
  Mesh mesh;
  std::vector<std::filesystem::path> inputs;  // other files that were read: material libraries
  std::vector<std::string> warnings;  // a material library that is missing, elements that are passed over
};

}  // namespace flexkey
