#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "cli/console.h"

namespace flexkey::cli {
namespace {

constexpr int bar_width = 28;

}  // namespace

Verbosity verbosity_of(const ShotOptions& options) {
  return options.quiet ? Verbosity::quiet : Verbosity::normal;
}

Progress::Progress(int total, Verbosity verbosity, const char* what)
    : what_(what),
      total_(std::max(1, total)),
      quiet_(verbosity == Verbosity::quiet),
      terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (!quiet_ && terminal_ && done_ > 0) say("\r\x1b[K");  // the report follows on a clean line
}

void Progress::pass() {
  ++passed_;
  start_ = Clock::now();
  advance();
}

void Progress::reach(int done) {
  done_ = std::max(done_, done);
  if (quiet_) return;
  const Clock::time_point now = Clock::now();
  const bool finished = done_ >= total_;
  const auto interval = std::chrono::milliseconds(terminal_ ? 50 : 500);
  const int percent = static_cast<int>(100LL * done_ / total_);
  if (percent == shown_percent_ || (!finished && now - last_shown_ < interval)) return;
  last_shown_ = now;
  shown_percent_ = percent;
  if (terminal_) {
    draw_bar(std::chrono::duration<double>(now - start_).count());
  } else {
    say(fmt::format("{}: {}%\n", what_, percent));
  }
}

void Progress::draw_bar(double seconds) const {
  const int filled = bar_width * std::min(done_, total_) / total_;
  std::string bar;
  for (int k = 0; k < bar_width; ++k) bar += k < filled ? "█" : "░";
  const double rate = seconds > 0 ? (done_ - passed_) / seconds : 0;
  const double left = rate > 0 ? (total_ - done_) / rate : 0;
  say(fmt::format("\r\x1b[K{} {}/{} frames  {:.1f} frames/s  {:.0f} s left", bar, done_, total_, rate, left));
}

}  // namespace flexkey::cli
