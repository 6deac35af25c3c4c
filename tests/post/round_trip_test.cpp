// What is posted is what is read back: programs of random toolpaths, read by this library and, where it is
// installed, by LinuxCNC's own interpreter.
#include <gtest/gtest.h>

#include "base/error.h"
#include "post/post.h"
#include "read/gcode/gcode.h"
#include "support/independent/rs274.h"
#include "support/programs.h"
#include "support/random/random_toolpaths.h"

namespace clearcut {
namespace {

using test_support::expect_same;
using test_support::options_for;
using test_support::RandomPath;

/// Moves join: what a Section promises.
void expect_joined(const Toolpath& toolpath) {
  for (const Section& section : toolpath.sections) {
    for (std::size_t k = 1; k < section.moves.size(); ++k) {
      EXPECT_EQ(section.moves[k - 1].path.to, section.moves[k].path.from);
      EXPECT_EQ(section.moves[k - 1].z_to, section.moves[k].z_from);
    }
  }
}

class RoundTrip : public ::testing::TestWithParam<std::string> {};

TEST_P(RoundTrip, RandomToolpathsComeBack) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const bool inch = seed % 2 == 0;
    const Toolpath toolpath = RandomPath(seed).toolpath(1 + static_cast<int>(seed % 7), 30);
    const std::string text = post::write_program(toolpath, Part{}, options_for(GetParam(), inch));
    const Program program = test_support::read_posted(text, GetParam(), toolpath);
    EXPECT_TRUE(program.ended);
    expect_joined(program.toolpath);
    const double rounding = post::rounding_of(options_for(GetParam(), inch));
    expect_same(toolpath, program.toolpath, rounding + Tolerances{}.chord, 2 * rounding);
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Dialects, RoundTrip, ::testing::ValuesIn(post::post_dialects()));

TEST(LinuxCnc, InterpreterMakesTheSameMotionOfRandomPrograms) {
  CLEARCUT_SKIP_WITHOUT_RS274();
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::string text =
        post::write_program(RandomPath(seed).toolpath(4, 100), Part{}, options_for("linuxcnc", false));
    const test_support::CanonProgram canon = test_support::run_rs274(text);
    ASSERT_TRUE(canon.accepted) << canon.message;
    test_support::expect_same_motion(canon, read::gcode::read_gcode(text, "random.ngc").toolpath, 2e-4);
    if (HasFailure()) return;
  }
}

TEST(LinuxCnc, InterpreterTakesEveryDialectCloseToItsOwn) {
  CLEARCUT_SKIP_WITHOUT_RS274();
  for (const char* dialect : {"linuxcnc", "mach3", "mach4"}) {
    for (const bool inch : {false, true}) {
      for (std::uint64_t seed = 100; seed < 102; ++seed) {
        SCOPED_TRACE(dialect + std::to_string(seed));
        const std::string text =
            post::write_program(RandomPath(seed).toolpath(4, 50), Part{}, options_for(dialect, inch));
        const test_support::CanonProgram canon = test_support::run_rs274(text);
        EXPECT_TRUE(canon.accepted) << canon.message;
      }
    }
  }
}

}  // namespace
}  // namespace clearcut
