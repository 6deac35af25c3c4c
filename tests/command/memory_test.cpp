// What a command may hold: beyond that it refuses in one line, and writes nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/file.h"
#include "support/command.h"

namespace clearcut {
namespace {

using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

/// A plate that takes some 20 m of path with a cutter of 1 mm.
const std::string kPlate = R"({"name": "plate", "units": "mm",
  "outer": [[0, 0, 0], [160, 0, 0], [160, 120, 0], [0, 120, 0]], "islands": [], "top": 0, "depth": 1})";

class Memory : public ::testing::Test {
 protected:
  ~Memory() override { ::unsetenv("CLEARCUT_MEMORY"); }
  void allow(const char* gigabytes) { ::setenv("CLEARCUT_MEMORY", gigabytes, 1); }
  auto plan(const char* strategy) {
    return run_clearcut({"plan", plate_, "--tool", "endmill:1", "--strategy", strategy, "-o",
                         folder_.path("plate.ngc"), "--quiet"});
  }
  ScratchFolder folder_;
  const std::string plate_ = folder_.file("plate.json", kPlate);
};

TEST_F(Memory, WhatNeedsMoreThanItsLimitIsRefusedInOneLine) {
  allow("0.003");
  const auto refused = plan("adaptive");
  EXPECT_EQ(refused.exit_code, 2) << refused.out << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("limit of memory"));
  EXPECT_THAT(refused.err, HasSubstr("wider cutter"));
  EXPECT_THAT(folder_.names(), ElementsAre("plate.json"));
}

TEST_F(Memory, WhatNeedsLessIsPlanned) {
  allow("0.5");
  const auto planned = plan("zigzag");
  EXPECT_EQ(planned.exit_code, 0) << planned.err;
}

TEST_F(Memory, PartsOfABatchHaveTheSameLimit) {
  allow("0.003");
  const std::string list = folder_.file("list.txt", "plate.json\n");
  const auto batch = run_clearcut({"batch", list, "--output", folder_.path("out"), "--tool", "endmill:1",
                                   "--strategy", "adaptive", "--part-memory", "4000"});
  EXPECT_EQ(batch.exit_code, 1) << batch.err;
  EXPECT_THAT(batch.out, HasSubstr("0 of 1 CLEAN, 1 UNUSABLE"));
  EXPECT_THAT(read_file(folder_.path("out/results.csv")), HasSubstr("limit of memory"));
}

TEST_F(Memory, ALimitThatIsNoNumberIsRefused) {
  allow("much");
  const auto refused = plan("zigzag");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("CLEARCUT_MEMORY=much is no number of GB"));
}

#endif

}  // namespace
}  // namespace clearcut
