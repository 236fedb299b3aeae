#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/report.h"
#include "cli/run_states.h"
#include "cli/session.h"

namespace flexkey::cli {

/// What a command has done so far.
struct Doings {
  std::filesystem::path report;  // where one is to be written; empty: nowhere
  std::vector<FamilyReport> families;
  std::vector<std::string> results;  // what it made, a path each
};

/// Refuses a report that could not be written. Throws TimelineError, OutputError.
void check_report(const Session& session);

/// Adds what was done with a session's runs, and says it to a person.
void note(const Session& session, std::vector<RunReport> reports, Doings& doings);

/// Prints what the command made or, as asked, its report for scripts, and writes that where the shot names
/// one. Returns the command's ExitCode. Throws OutputError.
int conclude(const ShotOptions& options, const Doings& doings);

/// Says what a signal left. fates: of outputs, a sentence each. Returns the command's exit code.
int conclude_stopped(const Session& session, const RunStates& states, std::size_t frames,
                     std::vector<std::string> fates);

}  // namespace flexkey::cli
