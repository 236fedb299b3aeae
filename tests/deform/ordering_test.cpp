#include "flexkey/deform/ordering.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <numeric>
#include <thread>
#include <vector>

#include "deform/matrices.h"

namespace flexkey {
namespace {

volatile std::sig_atomic_t noted = 0;

extern "C" void note(int) {
  noted = noted + 1;
}

TEST(FillReducingOrder, NumbersEachRowOnce) {
  for (const Eigen::SparseMatrix<double>& matrix : {grid(20, 20), squared(grid(20, 20))}) {
    const Permutation order = fill_reducing_order(matrix);
    std::vector<int> places(order.indices().begin(), order.indices().end()), all(places.size());
    std::sort(places.begin(), places.end());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(places, all);
  }
}

// METIS_NodeND takes SIGTERM for a fault of its own while it works, and leaves the order as it found it.
TEST(FillReducingOrder, LeavesSignalsToTheProgram) {
  const Eigen::SparseMatrix<double> matrix = squared(grid(60, 60));
  const Permutation alone = fill_reducing_order(matrix);
  noted = 0;
  const auto before = std::signal(SIGTERM, note);
  std::atomic<bool> over = false;
  std::thread disturbing([&] {
    for (; !over; std::this_thread::sleep_for(std::chrono::microseconds(20))) kill(getpid(), SIGTERM);
  });
  while (noted == 0) std::this_thread::yield();
  for (int k = 0; k < 10; ++k) EXPECT_EQ(fill_reducing_order(matrix).indices(), alone.indices());
  over = true;
  disturbing.join();
  std::signal(SIGTERM, before);
}

}  // namespace
}  // namespace flexkey
