#pragma once

#include <functional>
#include <vector>

namespace flexkey::bench {

/// What a measurement in a process of its own gave.
struct Measured {
  std::vector<double> values;
  double peak_bytes = 0;  // the most memory that the process had resident
};

/// Runs the work in a forked process, so that no measurement counts in another's memory. Throws Error if it
/// fails. The caller has started no threads, and stays small: a child begins with its pages.
Measured in_child(const std::function<std::vector<double>()>& work);

}  // namespace flexkey::bench
