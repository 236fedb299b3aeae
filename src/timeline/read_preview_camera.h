#pragma once

#include "flexkey/timeline/preview_output.h"
#include "flexkey/timeline/scope.h"

namespace flexkey {

/// `camera` of output.preview.
PreviewCamera read_preview_camera(const Node& node, Scope& scope);

}  // namespace flexkey
