#pragma once

#include <string_view>
#include <vector>

#include "flexkey/timeline/node.h"
#include "flexkey/timeline/scope.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// A path, or a mapping with one. place: "'gltf'", for messages.
GltfOutput read_gltf_output(const Node& node, std::string_view place, Scope& scope);

/// The top level's `clips`: {walk: [0s, 1s], …}.
std::vector<NamedInterval> read_clips(const Node& node, Scope& scope);

}  // namespace flexkey
