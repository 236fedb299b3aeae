#pragma once

#include <functional>
#include <memory>

namespace flexkey::cli {

/// Does work behind the back of whoever gives it: a queue of one. Giver and work share the threads that TBB
/// was allowed, and with one thread the work is done where the giver waits.
class Behind {
 public:
  Behind();
  /// Waits for the work; what it throws is lost.
  ~Behind();
  Behind(const Behind&) = delete;
  Behind& operator=(const Behind&) = delete;

  /// Waits for the work before, and throws what it threw.
  void start(std::function<void()> work);
  void finish();

 private:
  struct Group;
  std::unique_ptr<Group> group_;
};

}  // namespace flexkey::cli
