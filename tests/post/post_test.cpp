// What is posted is what is read back: programs of random toolpaths, read by this library and, where it is
// installed, by LinuxCNC's own interpreter.
#include "post/post.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "base/error.h"
#include "base/random.h"
#include "read/gcode/gcode.h"
#include "support/independent/grbl.h"
#include "support/independent/rs274.h"
#include "support/programs.h"

namespace clearcut {
namespace {

Vec2 random_point(Random& random, double size) {
  return {random.between(-size, size), random.between(-size, size)};
}

/// Toolpaths of lines, arcs of every size and sweep, helices, vertical moves and full circles. Every feed
/// move has a feed of its own, by which it is known again.
class RandomPath {
 public:
  explicit RandomPath(std::uint64_t seed) : random_(seed) { at_ = random_point(random_, 50); }

  Toolpath toolpath(int sections, int moves) {
    Toolpath path;
    for (int s = 0; s < sections; ++s) {
      Section section;
      section.label = "POCKET" + std::to_string(s);
      section.workingstep = s;
      section.tool_number = 1 + s / 2;
      section.spindle_rpm = 1000 * (1 + s / 3);
      section.spindle_clockwise = s % 5 != 4;
      section.coolant = s % 2 == 1;
      while (static_cast<int>(section.moves.size()) < moves) add_move(section);
      path.sections.push_back(std::move(section));
    }
    return path;
  }

 private:
  void add_move(Section& section) {
    Move move;
    move.z_from = z_;
    move.z_to = random_.below(3) == 0 ? random_.between(-10, 5) : z_;
    move.path = random_edge();
    if (move.is_vertical() && move.z_to == z_) return;
    const bool rapid = !move.path.is_arc() && !section.moves.empty() && random_.below(6) == 0;
    move.kind = rapid ? MoveKind::kRapid : MoveKind::kCut;
    if (!rapid) move.feed = MmPerMin::of(++feed_);
    at_ = move.path.to;
    z_ = move.z_to;
    section.moves.push_back(move);
  }

  Edge random_edge() {
    switch (random_.below(6)) {
      case 0:
        return Edge::line(at_, random_point(random_, 50));
      case 1:
        return Edge::line(at_, at_ + random_point(random_, 0.002));
      case 2:
        return Edge::line(at_, at_);
      default:
        return random_arc();
    }
  }

  Edge random_arc() {
    const double radius = std::pow(10, random_.between(-3, 5));
    const double widest = std::min(2 * kPi * 0.9999, 100 / radius);
    const double sweep = random_.below(4) == 0 ? std::min(widest, kPi) : widest * random_.unit();
    const double side = random_.below(2) == 0 ? 1 : -1;
    const double start = random_.between(0, 2 * kPi);
    const Vec2 center = at_ - direction_of(start) * radius;
    const Vec2 to = center + direction_of(start + side * sweep) * radius;
    if (distance(to, at_) < 1e-6) return Edge::line(at_, at_);
    return Edge::arc(at_, to, center, side > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
  }

  Random random_;
  Vec2 at_;
  double z_ = 0;
  double feed_ = 100;
};

struct Place3 {
  Vec2 point;
  double z = 0;
};

double distance(const Place3& a, const Place3& b) {
  return std::hypot(distance(a.point, b.point), a.z - b.z);
}

double length_of(const std::vector<Move>& moves) {
  double total = 0;
  for (const Move& move : moves) total += move.length();
  return total;
}

/// A run of moves as one curve.
Place3 place_on(const std::vector<Move>& moves, double fraction) {
  double left = fraction * length_of(moves);
  for (const Move& move : moves) {
    const double length = move.length();
    if (left <= length || &move == &moves.back()) {
      const double t = length > 0 ? std::clamp(left / length, 0.0, 1.0) : 1.0;
      return {move.is_vertical() ? move.path.to : move.path.at(t), std::lerp(move.z_from, move.z_to, t)};
    }
    left -= length;
  }
  return {};
}

/// Largest distance between two curves at equal fractions of their lengths.
double deviation_in_step(const std::vector<Move>& a, const std::vector<Move>& b) {
  constexpr int kSamples = 16;
  double largest = 0;
  for (int k = 0; k <= kSamples; ++k) {
    const double t = static_cast<double>(k) / kSamples;
    largest = std::max(largest, distance(place_on(a, t), place_on(b, t)));
  }
  return largest;
}

/// Largest distance in plan from a point of `a` to the nearest of `b`.
double deviation_aside(const std::vector<Move>& a, const std::vector<Move>& b) {
  double largest = 0;
  for (int k = 0; k <= 16; ++k) {
    const Vec2 p = place_on(a, k / 16.0).point;
    double least = HUGE_VAL;
    for (const Move& move : b) {
      least = std::min(least, move.is_vertical() ? distance(move.path.to, p) : distance(move.path, p));
    }
    largest = std::max(largest, least);
  }
  return largest;
}

/// Moves join: what a Section promises.
void expect_joined(const Toolpath& toolpath) {
  for (const Section& section : toolpath.sections) {
    for (std::size_t k = 1; k < section.moves.size(); ++k) {
      EXPECT_EQ(section.moves[k - 1].path.to, section.moves[k].path.from);
      EXPECT_EQ(section.moves[k - 1].z_to, section.moves[k].z_from);
    }
  }
}

/// Feed moves of a section by their feed, which each move of a RandomPath has for itself.
std::map<long long, std::vector<Move>> by_feed(const Section& section) {
  std::map<long long, std::vector<Move>> moves;
  long long last = 0;
  for (const Move& move : section.moves) {
    if (is_rapid(move.kind)) continue;
    const long long feed = std::llround(move.feed.mm_per_min());
    EXPECT_GE(feed, last) << "out of order at line " << move.line;
    last = feed;
    moves[feed].push_back(move);
  }
  return moves;
}

/// Correct means: the same sections with the same tool, spindle and coolant; within each, the feed moves of
/// the original in their order; no point of either beside the other by more than `aside`, and in step within
/// three times that (rounding also shortens and lengthens). Moves under `smallest` may be missing, rapids may
/// be added.
void expect_same(const Toolpath& wanted, const Toolpath& got, double aside, double smallest) {
  ASSERT_EQ(wanted.sections.size(), got.sections.size());
  for (std::size_t s = 0; s < wanted.sections.size(); ++s) {
    const Section& a = wanted.sections[s];
    const Section& b = got.sections[s];
    EXPECT_EQ(a.label, b.label);
    EXPECT_EQ(a.workingstep, b.workingstep);
    EXPECT_EQ(a.tool_number, b.tool_number);
    EXPECT_EQ(a.spindle_rpm, b.spindle_rpm);
    EXPECT_EQ(a.spindle_clockwise, b.spindle_clockwise);
    EXPECT_EQ(a.coolant, b.coolant);
    const auto read = by_feed(b);
    for (const auto& [feed, moves] : by_feed(a)) {
      const auto found = read.find(feed);
      if (found == read.end()) {
        EXPECT_LT(length_of(moves), smallest);
        continue;
      }
      const int line = found->second.front().line;
      EXPECT_LE(deviation_aside(moves, found->second), aside) << "line " << line;
      EXPECT_LE(deviation_aside(found->second, moves), aside) << "line " << line;
      EXPECT_LE(deviation_in_step(moves, found->second), 3 * aside) << "line " << line;
    }
  }
}

PostOptions options_for(const std::string& dialect, bool inch) {
  PostOptions options;
  options.dialect = dialect;
  options.inch = inch;
  return options;
}

class RoundTrip : public ::testing::TestWithParam<std::string> {};

TEST_P(RoundTrip, RandomToolpathsComeBack) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const bool inch = seed % 2 == 0;
    const Toolpath toolpath = RandomPath(seed).toolpath(1 + static_cast<int>(seed % 7), 30);
    const std::string text = post::write_program(toolpath, Part{}, options_for(GetParam(), inch));
    const read::gcode::Program program = test_support::read_posted(text, GetParam(), toolpath);
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

// -------------------------------------------------------------------------------------------- rules of
// dialects

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// A block's words, comments left out.
std::string words_of(const std::string& line) {
  return line.substr(0, line.find_first_of("(;"));
}

TEST(GrblChecker, KnowsTheErrors) {
  const std::vector<std::pair<std::string, int>> rows{
      {"%", 1},
      {"G1X", 2},
      {"M6", 20},
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
    for (const auto& fault : test_support::grbl_faults(text)) {
      ADD_FAILURE() << "seed " << seed << " line " << fault.line << " error " << fault.error << ": "
                    << fault.text;
    }
    if (HasFailure()) return;
  }
}

TEST(Dialects, LinesFitTheControl) {
  const std::map<std::string, std::size_t> limits{{"linuxcnc", 255}, {"grbl", 79},      {"fanuc", 80},
                                                  {"haas", 80},      {"mach3", 80},     {"mach4", 80},
                                                  {"marlin", 96},    {"heidenhain", 80}};
  ASSERT_EQ(limits.size(), post::post_dialects().size());
  for (const auto& [dialect, limit] : limits) {
    for (const bool inch : {false, true}) {
      PostOptions options = options_for(dialect, inch);
      options.decimals = 6;
      options.header = {std::string(300, 'X')};
      for (const std::string& line :
           lines_of(post::write_program(RandomPath(3).toolpath(3, 50), Part{}, options))) {
        EXPECT_LE(line.size(), limit) << dialect << ": " << line;
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

TEST(Dialects, FanucAndHaasAlwaysWriteThePoint) {
  for (const std::string dialect : {"fanuc", "haas"}) {
    int numbers = 0;
    for (const std::string& line :
         lines_of(post::write_program(RandomPath(6).toolpath(3, 50), Part{}, options_for(dialect, false)))) {
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
  const std::map<std::string, std::vector<std::string>> never{
      {"grbl", {"M6", "G43", "G64", "G61", "%", "H"}},
      {"marlin", {"M6", "M30", "G28", "G43", "G54", "G21", "T", "(", "%"}},
      {"mach3", {"%"}},
      {"fanuc", {"G91.1", "G64"}},
      {"haas", {"G91.1", "G64", "G28"}},
  };
  for (const auto& [dialect, words] : never) {
    const std::string text =
        post::write_program(RandomPath(7).toolpath(6, 10), Part{}, options_for(dialect, false));
    for (const std::string& line : lines_of(text)) {
      for (const std::string& word : words) EXPECT_EQ(words_of(line).find(word), std::string::npos) << line;
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
    const read::gcode::Program program =
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
