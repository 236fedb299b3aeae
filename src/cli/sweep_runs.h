#pragma once

#include <vector>

#include "cli/options.h"
#include "flexkey/timeline/shot.h"

namespace flexkey::cli {

/// The runs of a part of a sweep, as even as can be. Throws UsageError where it has none.
std::vector<Shot> runs_of_chunk(const Chunk& chunk, const std::vector<Shot>& runs);

/// Runs that differ in λ alone, which one factor solves, together; families in the order of their first runs.
std::vector<std::vector<Shot>> families_of(const std::vector<Shot>& runs);

/// "λ = 0.5, solver.iterations = 3": what tells a run from the others; empty: it is the only one.
std::string run_title(const std::vector<SweptValue>& swept);

}  // namespace flexkey::cli
