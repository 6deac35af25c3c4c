// What is said of a drawing before it is planned: all that was understood, and what is still missing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/command.h"

namespace clearcut {
namespace {

using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string circle_on(const std::string& layer) {
  return "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\n" + layer + "\n10\n20\n20\n15\n40\n4\n0\nENDSEC\n0\nEOF\n";
}

TEST(Info, AsksNoDepthOfCarvingsThatFollowTheirOutlines) {
  const auto info = run_clearcut({"info", std::string(CLEARCUT_SOURCE_DIR) + "/examples/sign.dxf"});
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_THAT(info.out, AllOf(HasSubstr("no depth: vcarve"), HasSubstr("VCARVE_3  v_carving"),
                              Not(HasSubstr("to be said"))));
}

TEST(Info, ShowsADrawingThatLacksADepth) {
  const ScratchFolder folder;
  const auto info = run_clearcut({"info", folder.file("pocket.dxf", circle_on("POCKET"))});
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_THAT(info.out, AllOf(HasSubstr("circle of 8"), HasSubstr("to be said: "), HasSubstr("--depth 5")));
}

TEST(Info, ShowsADrawingWhoseHolesGoThroughAnUnknownThickness) {
  const ScratchFolder folder;
  const auto info = run_clearcut({"info", folder.file("hole.dxf", circle_on("DRILL_THRU"))});
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_THAT(info.out, AllOf(HasSubstr("circle of 8"), HasSubstr("to be said: "), HasSubstr("STOCK_D12")));
}

}  // namespace
}  // namespace clearcut
