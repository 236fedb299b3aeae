#pragma once

#include <vector>

#include "flexkey/timeline/scope.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// `attach`: a list of {select, to}.
std::vector<Attachment> read_attachments(const Node& node, Scope& scope);

}  // namespace flexkey
