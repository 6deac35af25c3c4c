// What posts write: the rules of each control.
#include "post/post.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "base/error.h"
#include "read/gcode/gcode.h"
#include "support/controllers.h"
#include "support/independent/grbl.h"
#include "support/programs.h"
#include "support/random/random_toolpaths.h"

namespace clearcut {
namespace {

using test_support::expect_same;
using test_support::options_for;
using test_support::RandomPath;

// -------------------------------------------------------------------------------------------- rules of
// dialects

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// A block's words, comments left out, and what Marlin shows at a pause.
std::string words_of(const std::string& line) {
  if (line.starts_with("M0 ")) return "M0";
  return line.substr(0, line.find_first_of("(;"));
}

TEST(GrblChecker, KnowsTheErrors) {
  const std::vector<std::pair<std::string, int>> rows{
      {"%", 1},
      {"G1X", 2},
      {"M6", 20},
      {"M7", 20},
      {"G43 H1", 20},
      {"G41", 20},
      {"G64 P0.01", 20},
      {"G90.1", 20},
      {"G0 A1", 20},
      {"G0 G1 X1 F1", 21},
      {"G1 X1", 22},
      {"G0 X1 X2", 25},
      {"G2 F100", 26},
      {"G2 Z1 I5 F100", 32},
      {"G2 X10 I5.3 F100", 33},
      {"G2 X10 R4 F100", 34},
      {"G2 X10 F100", 35},
      {"G1 X10 I4 F100", 36},
      {"G4", 28},
      {"G80 X1", 31},
      {"G1 X1 F100 (a comment)", 0},
      {"G17 G21 G40 G49 G54 G80 G90 G91.1 G94", 0},
      {"G2 X10 Y0 I5 J0 F100", 0},
      {"G1 X" + std::string(90, '0') + "1 F100", 11},
  };
  for (const auto& [line, error] : rows) {
    const auto faults = test_support::grbl_faults(line);
    EXPECT_EQ(faults.empty() ? 0 : faults[0].error, error) << line;
  }
}

TEST(Grbl, TakesEveryLine) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const std::string text =
        post::write_program(RandomPath(seed).toolpath(4, 60), Part{}, options_for("grbl", seed % 2 == 0));
    for (const auto& fault : test_support::grbl_faults(text, true)) {
      ADD_FAILURE() << "seed " << seed << " line " << fault.line << " error " << fault.error << ": "
                    << fault.text;
    }
    if (HasFailure()) return;
  }
}

TEST(Dialects, HaveARowOfExpectationsEach) {
  std::vector<std::string> rows;
  for (const test_support::Controller& one : test_support::controllers()) rows.emplace_back(one.name);
  EXPECT_EQ(rows, controller_names());
}

TEST(Dialects, LinesFitTheControl) {
  for (const test_support::Controller& one : test_support::controllers()) {
    for (const bool inch : {false, true}) {
      PostOptions options = options_for(std::string(one.name), inch);
      options.decimals = 6;
      options.header = {std::string(300, 'X')};
      for (const std::string& line :
           lines_of(post::write_program(RandomPath(3).toolpath(3, 50), Part{}, options))) {
        EXPECT_LE(line.size(), one.line_length) << one.name << ": " << line;
      }
    }
  }
}

TEST(Dialects, NumbersAreNeverMinusZeroOrExponents) {
  for (const std::string& dialect : post::post_dialects()) {
    for (const std::string& line :
         lines_of(post::write_program(RandomPath(5).toolpath(5, 100), Part{}, options_for(dialect, false)))) {
      const std::string words = words_of(line) + " ";
      EXPECT_EQ(words.find("-0 "), std::string::npos) << line;
      EXPECT_EQ(words.find("-0. "), std::string::npos) << line;
      EXPECT_EQ(words.find("+-"), std::string::npos) << line;
      EXPECT_EQ(words.find('e'), std::string::npos) << line;
    }
  }
}

TEST(Dialects, ThatCountIncrementsWithoutAPointAlwaysWriteIt) {
  for (const test_support::Controller& one : test_support::controllers()) {
    if (!one.always_point) continue;
    int numbers = 0;
    for (const std::string& line : lines_of(post::write_program(RandomPath(6).toolpath(3, 50), Part{},
                                                                options_for(std::string(one.name), false)))) {
      std::istringstream words(words_of(line));
      for (std::string word; words >> word;) {
        if (std::string("XYZIJF").find(word[0]) == std::string::npos) continue;
        EXPECT_NE(word.find('.'), std::string::npos) << line;
        ++numbers;
      }
    }
    EXPECT_GT(numbers, 100);
  }
}

TEST(Dialects, WordsAControlDoesNotKnowAreNotWritten) {
  for (const test_support::Controller& one : test_support::controllers()) {
    const std::string text =
        post::write_program(RandomPath(7).toolpath(6, 10), Part{}, options_for(std::string(one.name), false));
    for (const std::string& line : lines_of(text)) {
      for (const std::string_view word : one.never)
        EXPECT_EQ(words_of(line).find(word), std::string::npos) << line;
    }
  }
}

TEST(Dialects, EveryFirstFeedMoveAfterARapidSaysItsFeed) {
  for (const std::string& dialect : post::post_dialects()) {
    if (dialect == "heidenhain") continue;
    bool after_rapid = true;
    int checked = 0;
    for (const std::string& line :
         lines_of(post::write_program(RandomPath(8).toolpath(6, 30), Part{}, options_for(dialect, false)))) {
      const std::string words = words_of(line) + " ";
      if (words.rfind("G0 ", 0) == 0) after_rapid = true;
      if (words.rfind('F', 0) == 0) after_rapid = false;  // in a block of its own where the next is long
      const bool feeds =
          words.rfind("G1 ", 0) == 0 || words.rfind("G2 ", 0) == 0 || words.rfind("G3 ", 0) == 0;
      if (!feeds || !after_rapid) continue;
      EXPECT_NE(words.find('F'), std::string::npos) << line;
      after_rapid = false;
      ++checked;
    }
    EXPECT_GT(checked, 5) << dialect;
  }
}

TEST(Klartext, BlocksAreNumberedWithoutGaps) {
  int number = 0;
  for (const std::string& line : lines_of(
           post::write_program(RandomPath(9).toolpath(3, 20), Part{}, options_for("heidenhain", false)))) {
    EXPECT_EQ(line.substr(0, line.find(' ')), std::to_string(number++)) << line;
  }
  EXPECT_GT(number, 60);
}

TEST(Post, LinesOnlyWhenAskedFor) {
  const Toolpath toolpath = RandomPath(10).toolpath(2, 40);
  for (const std::string& dialect : post::post_dialects()) {
    PostOptions options = options_for(dialect, false);
    options.arcs = false;
    options.tol.chord = 0.001;
    const Program program =
        test_support::read_posted(post::write_program(toolpath, Part{}, options), dialect, toolpath);
    for (const Section& section : program.toolpath.sections) {
      for (const Move& move : section.moves) EXPECT_FALSE(move.path.is_arc()) << dialect;
    }
    const double rounding = post::rounding_of(options);
    expect_same(toolpath, program.toolpath, rounding + options.tol.chord, 2 * rounding);
  }
}

TEST(Post, InchAndMetricAgree) {
  const Toolpath toolpath = RandomPath(11).toolpath(3, 60);
  for (const std::string& dialect : post::post_dialects()) {
    const Toolpath mm =
        read::gcode::read_gcode(post::write_program(toolpath, Part{}, options_for(dialect, false)), "mm")
            .toolpath;
    const Toolpath inch =
        read::gcode::read_gcode(post::write_program(toolpath, Part{}, options_for(dialect, true)), "inch")
            .toolpath;
    const double rounding =
        post::rounding_of(options_for(dialect, false)) + post::rounding_of(options_for(dialect, true));
    expect_same(mm, inch, rounding + Tolerances{}.chord, 2 * rounding);
  }
}

TEST(Post, CommentsCannotBreakOut) {
  Toolpath toolpath = RandomPath(12).toolpath(1, 3);
  toolpath.sections[0].label = "A (nested) % ! ~ ?\nG0 Z-50";
  for (const std::string& dialect : post::post_dialects()) {
    PostOptions options = options_for(dialect, false);
    options.header = {"MSG, DEBUG", "a\r\nM3 S99999", "50 % (stock)", "h\xC3\xA9 \x18 ~!?"};
    options.program_name = "PART (1)\n%";
    const std::string text = post::write_program(toolpath, Part{}, options);
    for (const std::string& line : lines_of(text)) {
      EXPECT_EQ(line.find_first_of("!~?\r\x18\xC3"), std::string::npos) << line;
      EXPECT_EQ(line.find("(MSG,"), std::string::npos) << line;
      EXPECT_LE(std::count(line.begin(), line.end(), '('), 1) << line;
      EXPECT_EQ(words_of(line).find("S99999"), std::string::npos) << line;
      EXPECT_TRUE(line == "%" || line.find('%') == std::string::npos) << line;
    }
    EXPECT_EQ(read::gcode::read_gcode(text, "comments").toolpath.sections.size(), 1U);
  }
}

TEST(Post, SwitchesUsersAskFor) {
  const Toolpath toolpath = RandomPath(13).toolpath(4, 5);
  PostOptions options;
  options.tool_changer = false;
  options.exact_stop = true;
  options.spindle_wait = Seconds::of(2.5);
  const std::string text = post::write_program(toolpath, Part{}, options);
  EXPECT_EQ(text.find("M6"), std::string::npos);
  EXPECT_EQ(text.find("G43"), std::string::npos);
  EXPECT_EQ(text.find("G64"), std::string::npos);
  EXPECT_NE(text.find("\nM0\n"), std::string::npos);
  EXPECT_NE(text.find("\nG61\n"), std::string::npos);
  EXPECT_NE(text.find("\nG4 P2.5\n"), std::string::npos);
  PostOptions without_length;
  without_length.length_offset = false;
  EXPECT_EQ(post::write_program(toolpath, Part{}, without_length).find("G43"), std::string::npos);
}

TEST(Post, RefusesUnknownDialectsAndNumbersThatAreNone) {
  Toolpath toolpath = RandomPath(1).toolpath(1, 3);
  EXPECT_THROW(post::write_program(toolpath, Part{}, options_for("basic", false)), InputError);
  for (const double bad : {std::nan(""), HUGE_VAL, 1e9}) {
    Toolpath broken = toolpath;
    broken.sections[0].moves[0].path.from.x = bad;
    EXPECT_THROW(post::write_program(broken, Part{}, options_for("linuxcnc", false)), InputError) << bad;
  }
}

}  // namespace
}  // namespace clearcut
