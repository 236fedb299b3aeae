#pragma once

namespace flexkey::cli {

/// From now on SIGINT and SIGTERM are noted instead of ending the program; a second one ends it at once.
void note_signals();

/// The noted signal, or 0.
int noted_signal();

}  // namespace flexkey::cli
