#pragma once

#include <vector>

#include "flexkey/timeline/scope.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// What `output` names.
struct Outputs {
  GltfOutput gltf;
  std::vector<CacheOutput> caches;
  HtmlOutput html;
  PreviewOutput preview;
  ReportOutput report;
};

/// `output`: the path of a GLB, or {gltf, cache, frames, usd, html, preview, report}. What is not named has
/// no path.
Outputs read_output(const Node& node, Scope& scope);

}  // namespace flexkey
