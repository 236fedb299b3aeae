#pragma once

#include <vector>

#include "flexkey/timeline/frame_ranges.h"
#include "flexkey/timeline/scope.h"

namespace flexkey {

/// Frames and ranges of them: a list such as [0-30, 47, 60-90x2], or a text "0-30,47,60-90x2".
std::vector<FrameRange> read_frame_ranges(const Node& node, Scope& scope);

}  // namespace flexkey
