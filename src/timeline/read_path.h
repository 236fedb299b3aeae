#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "flexkey/timeline/node.h"
#include "flexkey/timeline/scope.h"

namespace flexkey {

/// The text of a path, or nothing and an error. place: "'path' in 'gltf'", for messages.
std::optional<std::string> read_path(const Node& node, std::string_view place, Scope& scope);

}  // namespace flexkey
