#pragma once

#include "flexkey/timeline/node.h"
#include "flexkey/timeline/scope.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// `html` in `output`: a path, or {path: …}.
HtmlOutput read_html_output(const Node& node, Scope& scope);

}  // namespace flexkey
