#pragma once

namespace flexkey::cli {

/// From now on SIGINT, SIGTERM and SIGHUP are noted instead of ending the program; a second one ends it at
/// once.
void note_signals();

/// From now on a closed pipe or a file-size limit makes a write fail instead of ending the program.
void report_failed_writes();

/// The noted signal, or 0.
int noted_signal();

}  // namespace flexkey::cli
