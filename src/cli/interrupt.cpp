#include "cli/interrupt.h"

#include <csignal>

namespace flexkey::cli {
namespace {

volatile std::sig_atomic_t noted = 0;

extern "C" void note(int signal) {
  noted = signal;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void note_signals() {
  std::signal(SIGINT, note);
  std::signal(SIGTERM, note);
  // A reader that went away shows as a failed write, which has an exit code of its own.
  std::signal(SIGPIPE, SIG_IGN);
}

int noted_signal() {
  return noted;
}

}  // namespace flexkey::cli
