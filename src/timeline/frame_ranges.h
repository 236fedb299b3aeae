#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "flexkey/mesh/selection.h"

namespace flexkey {

/// Every `step`-th frame from `first` to `last`, which is one of them if the step meets it.
struct FrameRange {
  int first = 0, last = 0, step = 1;
  Mark where = {};
};

/// "47", "0-30" or "60-90x2"; nothing for any other text.
std::optional<FrameRange> parse_frame_range(std::string_view text);

/// The frames of all ranges, increasing, none twice.
std::vector<int> frames_in(const std::vector<FrameRange>& ranges);

}  // namespace flexkey
