#include "cli/behind.h"

#include <tbb/task_group.h>

#include <exception>

namespace flexkey::cli {

struct Behind::Group {
  tbb::task_group tasks;
  std::exception_ptr failure;
};

Behind::Behind() : group_(std::make_unique<Group>()) {}

Behind::~Behind() {
  group_->tasks.wait();
}

void Behind::start(std::function<void()> work) {
  finish();
  group_->tasks.run([group = group_.get(), work = std::move(work)] {
    try {
      work();
    } catch (...) {
      group->failure = std::current_exception();
    }
  });
}

void Behind::finish() {
  group_->tasks.wait();
  if (group_->failure) std::rethrow_exception(std::exchange(group_->failure, nullptr));
}

}  // namespace flexkey::cli
