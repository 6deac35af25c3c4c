#include "base/apart.h"

#include <gtest/gtest.h>

namespace clearcut {
namespace {

TEST(DoneApart, HandsOverMoreThanAPipeHolds) {
  const std::string long_text(1 << 20, 'x');
  EXPECT_EQ(done_apart({"/bin/cat"}, long_text, 10), long_text);
}

TEST(DoneApart, CrashesErrorsAndEndlessWorkAreNothing) {
  EXPECT_EQ(done_apart({"/bin/sh", "-c", "echo half; kill -SEGV $$"}, "", 10), std::nullopt);
  EXPECT_EQ(done_apart({"/bin/sh", "-c", "echo half; exit 3"}, "", 10), std::nullopt);
  EXPECT_EQ(done_apart({"/bin/sh", "-c", "while :; do :; done"}, "", 1), std::nullopt);
  EXPECT_EQ(done_apart({"/nonexistent/program"}, "", 10), std::nullopt);
}

}  // namespace
}  // namespace clearcut
