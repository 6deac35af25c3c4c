// What a drawing hides and the reader cannot leave out counts in the verdict, until somebody accepts it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/command.h"

namespace clearcut {
namespace {

using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr int kConditional = 1;

std::string drawing(const std::string& hidden_by) {
  return "<svg xmlns='http://www.w3.org/2000/svg' width='60mm' height='40mm' viewBox='0 0 60 40'>"
         "<mask id='m'><rect width='30' height='40' fill='white'/></mask>"
         "<clipPath id='c'><rect width='30' height='40'/></clipPath>"
         "<circle cx='30' cy='20' r='15' " +
         hidden_by + "/></svg>";
}

TEST(NotAsDrawn, MasksLeaveTheVerdictConditional) {
  const ScratchFolder folder;
  std::vector<std::string> call{"plan",    folder.file("half.svg", drawing("mask='url(#m)'")),
                                "--depth", "2",
                                "--tool",  "endmill:4",
                                "-o",      folder.path("half.ngc")};
  const auto open = run_clearcut(call);
  EXPECT_EQ(open.exit_code, kConditional) << open.out << open.err;
  EXPECT_THAT(open.out, HasSubstr("verdict: CONDITIONAL"));
  EXPECT_THAT(open.out, HasSubstr("1 elements have a mask, which is not applied"));
  const auto checked = run_clearcut({"verify", folder.path("half.ngc"), "--part", folder.path("half.svg"),
                                     "--depth", "2", "--tool", "endmill:4"});
  EXPECT_EQ(checked.exit_code, kConditional) << checked.out << checked.err;
  call.insert(call.end(), {"--accept", "not-as-drawn"});
  const auto accepted = run_clearcut(call);
  EXPECT_EQ(accepted.exit_code, 0) << accepted.out << accepted.err;
}

TEST(NotAsDrawn, ClipPathsAreApplied) {
  const ScratchFolder folder;
  const auto result =
      run_clearcut({"plan", folder.file("half.svg", drawing("clip-path='url(#c)'")), "--depth", "2", "--tool",
                    "endmill:0.5", "--accept", "out-of-reach", "-o", folder.path("half.ngc")});
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_THAT(result.out, Not(HasSubstr("not-as-drawn")));
}

}  // namespace
}  // namespace clearcut
