#pragma once

#include <vector>

#include "flexkey/timeline/findings.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// Checks the placeholders of the shot's output paths: none unknown, `<lambda>` only where it has one value,
/// and all keys named of which a sweep has several values.
void check_output_paths(const Shot& shot, Findings& findings);

/// Puts the run's values for placeholders into its output paths.
void expand_output_paths(Shot& run);

/// Refuses runs that would write the same file.
void check_runs_apart(const std::vector<Shot>& runs, Findings& findings);

}  // namespace flexkey
