#pragma once

#include <string>

#include "cli/options.h"

namespace flexkey::cli {

/// What `flexkey watch` does after a save: drafts of the pictures, each as soon as its frame is solved, then
/// all that the shot names; says in a line each what was made. cause: "shot.yaml saved". Returns an ExitCode.
int run_round(const ShotOptions& options, const std::string& cause);

}  // namespace flexkey::cli
