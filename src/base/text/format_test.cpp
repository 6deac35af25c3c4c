#include "base/text/format.h"

#include <gmock/gmock.h>

namespace clearcut::inline base {
namespace {

using ::testing::ElementsAre;

TEST(Format, TrimsZerosAndNeverWritesAMinusZero) {
  EXPECT_EQ(trimmed(1.5, 4), "1.5");
  EXPECT_EQ(trimmed(-2, 3), "-2");
  EXPECT_EQ(trimmed(100, 0), "100");
  EXPECT_EQ(trimmed(-0.00004, 4), "0");
}

TEST(Format, SplitKeepsEmptyParts) {
  EXPECT_THAT(split("a:bc:d", ':'), ElementsAre("a", "bc", "d"));
  EXPECT_THAT(split(",a,,", ','), ElementsAre("", "a", "", ""));
  EXPECT_THAT(split("", ','), ElementsAre(""));
}

}  // namespace
}  // namespace clearcut::inline base
