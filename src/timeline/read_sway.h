#pragma once

#include <string_view>
#include <vector>

#include "flexkey/timeline/motion.h"
#include "flexkey/timeline/scope.h"

namespace flexkey {

/// One mapping or a list of them. place: "'wave' of handle 'tip'".
std::vector<Wave> read_waves(const Node& node, std::string_view place, Scope& scope);
std::vector<Noise> read_noises(const Node& node, std::string_view place, Scope& scope);

}  // namespace flexkey
