#pragma once

#include <functional>

namespace flexkey {

/// Counts what takes the time of writing, to say how much of it is done.
class Steps {
 public:
  /// total: at least 1. on_progress may be empty.
  Steps(std::size_t total, const std::function<void(double share)>& on_progress)
      : total_(total), on_progress_(on_progress) {}

  void advance() {
    if (done_ < total_) ++done_;
    if (on_progress_) on_progress_(static_cast<double>(done_) / static_cast<double>(total_));
  }

 private:
  std::size_t done_ = 0, total_;
  const std::function<void(double)>& on_progress_;
};

}  // namespace flexkey
