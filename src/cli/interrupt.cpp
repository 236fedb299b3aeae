#include "cli/interrupt.h"

#include <csignal>
#include <initializer_list>

namespace flexkey::cli {
namespace {

volatile std::sig_atomic_t noted = 0;

extern "C" void note(int signal) {
  noted = signal;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void note_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, note);
}

void report_failed_writes() {
  // A reader that went away and a file-size limit show as failed writes, which have an exit code of their
  // own.
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
}

int noted_signal() {
  return noted;
}

}  // namespace flexkey::cli
