#pragma once

#include <chrono>

#include "cli/options.h"

namespace flexkey::cli {

enum class Verbosity { normal, quiet };

Verbosity verbosity_of(const ShotOptions& options);

/// How far a run is, on stderr: a bar with frames a second and time left on a terminal, else plain
/// `Progress: 37%` lines, at most two a second, as render farms read them.
class Progress {
 public:
  /// what: the word before the percentage.
  Progress(int total, Verbosity verbosity, const char* what = "Progress");
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance() { reach(done_ + 1); }
  /// One that was done before, which takes no time and does not count in the frames a second.
  void pass();
  /// done: of `total`; never fewer than before.
  void reach(int done);

 private:
  using Clock = std::chrono::steady_clock;
  void draw_bar(double seconds) const;

  const char* what_;
  int total_, done_ = 0, passed_ = 0, shown_percent_ = -1;
  bool quiet_, terminal_;
  Clock::time_point start_ = Clock::now(), last_shown_{};
};

}  // namespace flexkey::cli
