#pragma once

namespace flexkey::cli {

/// What the program's exit tells a script or a farm. Of these only `unwritten` is worth a retry.
enum ExitCode : int {
  done = 0,
  internal_fault = 1,
  bad_timeline = 2,         // or bad usage
  bad_input = 3,            // a mesh or another input
  not_converged = 4,        // under --strict
  unwritten = 5,            // an output could not be written
  stopped_by_signal = 128,  // plus the signal: 130 SIGINT, 143 SIGTERM
};

}  // namespace flexkey::cli
