#pragma once

namespace flexkey::bench {

/// A global solve against the machine: the factor has to be read twice, forwards and backwards.
struct Limit {
  int vertices = 0;
  double bandwidth = 0;     // bytes a second that one thread reads
  double factor_bytes = 0;  // of the values alone, so that a store with much else to it does not look better
  double solve = 0;         // CPU seconds of one global solve, three right-hand sides
  double bound() const { return 2 * factor_bytes / bandwidth; }  // seconds
};

/// On the blob of that size, `direct`, one thread.
Limit measure_limit(int blob);

}  // namespace flexkey::bench
