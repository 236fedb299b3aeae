#pragma once

#include <string>
#include <vector>

#include "cli/report.h"
#include "cli/run_states.h"
#include "cli/session.h"

namespace flexkey::cli {

/// What the runs of a session have written.
struct Outcome {
  std::vector<RunReport> reports;
  std::vector<std::string> warnings;  // of the pictures; whole lines
  std::vector<std::string> fates;     // what becomes of the rest where a signal stopped them; a sentence each
};

/// Solves what is not solved yet and writes what the session's shot names, until it is done or a signal is
/// noted. Throws what is wrong with the outputs, before the solve as far as it can be known.
Outcome write_outputs(const Session& session, RunStates& states);

/// The paths of what was written.
std::vector<std::string> results_of(const std::vector<RunReport>& reports);

}  // namespace flexkey::cli
