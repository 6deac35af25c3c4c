#include "base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>

namespace clearcut::inline base {
namespace {

TEST(Parallel, EveryIndexIsDoneOnce) {
  std::atomic<int> sum = 0;
  parallel_for(3, 100, [&](int i) { sum += i; });
  EXPECT_EQ(sum, 99 * 100 / 2 - 3);
}

TEST(Parallel, WhatTheWorkThrowsComesOut) {
  EXPECT_THROW(parallel_for(0, 10,
                            [](int i) {
                              if (i == 4) throw std::runtime_error("4");
                            }),
               std::runtime_error);
}

/// Candidates are planned side by side, each with loops of its own: when one of them is cancelled, the others must not take a
/// half-done loop for a whole one.
TEST(Parallel, ALoopThatFailsAroundItDoesNotCutItShort) {
  std::atomic<int> done = 0;
  tbb::task_group_context around;
  tbb::parallel_for(
      0, 1,
      [&](int) {
        around.cancel_group_execution();
        parallel_for(0, 1000, [&](int) { ++done; });
      },
      around);
  EXPECT_EQ(done, 1000);
}

TEST(ParallelInOrder, ThrowsWhatTheFirstOfThoseThatThrowHasThrown) {
  std::atomic<int> run{0};
  const auto work = [&](std::size_t i) {
    ++run;
    if (i % 7 == 3) throw std::runtime_error(std::to_string(i));
  };
  for (const int threads : {1, 4}) {
    on_threads(threads, [&] {
      try {
        parallel_in_order(100, work);
        FAIL() << "nothing was thrown";
      } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "3");
      }
    });
  }
  EXPECT_EQ(run, 200);
}

}  // namespace
}  // namespace clearcut::inline base
