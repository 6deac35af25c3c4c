#include "base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

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

}  // namespace
}  // namespace clearcut::inline base
