#pragma once

#include "flexkey/timeline/findings.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// Checks the placeholders of the shot's output paths: none unknown, `<lambda>` only where it has one value a
/// run and always where a sweep has several.
void check_output_paths(const Shot& shot, Findings& findings);

}  // namespace flexkey
