#pragma once

#include <string_view>

#include "flexkey/gltf/glb.h"

namespace flexkey {

/// Takes a .glb or .gltf file apart, told by its content. Only its framing is checked: chunks that end before
/// the file does, versions, JSON that can be read and is nested at most 100 deep.
/// Throws InputError.
Glb split_container(std::string_view file);

}  // namespace flexkey
