#pragma once

#include "flexkey/timeline/scope.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// `preview` of `output`: the folder of its pictures, or a mapping.
PreviewOutput read_preview_output(const Node& node, Scope& scope);

/// Gives the preview of a shot that is read the paths that the timeline leaves out, and reports frames and
/// times behind the shot's end.
void complete_preview(Shot& shot, Findings& findings);

}  // namespace flexkey
