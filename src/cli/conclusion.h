#pragma once

#include <string>
#include <vector>

#include "cli/report.h"
#include "cli/run_states.h"
#include "cli/session.h"

namespace flexkey::cli {

/// Prints what was done, for a person and, as asked, for scripts. Returns the command's ExitCode.
/// results: what the command made, a path each.
int conclude(const Session& session, const std::vector<RunReport>& reports,
             const std::vector<std::string>& results);

/// Says what a signal left. fates: of outputs, a sentence each. Returns the command's exit code.
int conclude_stopped(const Session& session, const RunStates& states, std::size_t frames,
                     std::vector<std::string> fates);

}  // namespace flexkey::cli
