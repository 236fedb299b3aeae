#pragma once

#include <chrono>
#include <ctime>

namespace flexkey::bench {

/// CPU time that all threads of this process have used.
inline double cpu_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The time on that clock which the work takes.
template <class Clock, class Work>
double seconds_of(const Clock& clock, const Work& work) {
  const double start = clock();
  work();
  return clock() - start;
}

}  // namespace flexkey::bench
