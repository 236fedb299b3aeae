#include "cli/behind.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <future>
#include <stdexcept>
#include <thread>
#include <vector>

namespace flexkey::cli {
namespace {

TEST(Behind, WorksWhileItsGiverGoesOn) {
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "nobody could work beside the giver";
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 2);
  std::promise<void> given;
  bool is_done = false;
  Behind behind;
  behind.start([&, signal = given.get_future().share()] {
    signal.wait();  // for ever, if `start` waited for the work
    is_done = true;
  });
  given.set_value();
  behind.finish();
  EXPECT_TRUE(is_done);
}

TEST(Behind, KeepsTheOrderWithAnyThreads) {
  for (const std::size_t count : {1, 2, 4}) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, count);
    std::vector<int> first, second;
    Behind behind, farther;
    for (int k = 0; k < 50; ++k)
      behind.start([&, k] {
        first.push_back(k);
        farther.start([&, k] { second.push_back(k); });
      });
    behind.finish();
    farther.finish();
    EXPECT_TRUE(std::is_sorted(first.begin(), first.end()));
    EXPECT_EQ(first.size(), 50u);
    EXPECT_EQ(first, second);
  }
}

TEST(Behind, ThrowsWhatTheWorkThrew) {
  Behind behind;
  behind.start([] { throw std::runtime_error("full"); });
  EXPECT_THROW(behind.start([] {}), std::runtime_error);
  behind.start([] { throw std::runtime_error("full"); });
  EXPECT_THROW(behind.finish(), std::runtime_error);
  EXPECT_NO_THROW(behind.finish()) << "once";
}

}  // namespace
}  // namespace flexkey::cli
