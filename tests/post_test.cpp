// What is posted is what is read back: programs of random toolpaths, read by this library and, where it is
// installed, by LinuxCNC's own interpreter.
#include "post/post.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "base/random.h"
#include "read/gcode/gcode.h"
#include "support/rs274.h"

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

/// A run of moves as one curve.
Place3 place_on(const std::vector<Move>& moves, double fraction) {
  double total = 0;
  for (const Move& move : moves) total += move.length();
  double left = fraction * total;
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
double deviation(const std::vector<Move>& a, const std::vector<Move>& b) {
  constexpr int kSamples = 16;
  double largest = 0;
  for (int k = 0; k <= kSamples; ++k) {
    const double t = static_cast<double>(k) / kSamples;
    largest = std::max(largest, distance(place_on(a, t), place_on(b, t)));
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

/// Correct means: the same sections with the same tool, spindle and coolant; within each, the feed moves of
/// the original in their order, every point within `tolerance` of the original point. Rapids may be added.
void expect_same(const Toolpath& wanted, const Toolpath& got, double tolerance, double smallest_move) {
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
    std::map<long long, std::vector<Move>> read;
    long long last = 0;
    for (const Move& move : b.moves) {
      if (is_rapid(move.kind)) continue;
      const long long feed = std::llround(move.feed.mm_per_min());
      EXPECT_GE(feed, last) << "out of order at line " << move.line;
      last = feed;
      read[feed].push_back(move);
    }
    for (const Move& move : a.moves) {
      if (is_rapid(move.kind)) continue;
      const auto found = read.find(std::llround(move.feed.mm_per_min()));
      if (found == read.end()) {
        EXPECT_LT(move.length(), smallest_move);
        continue;
      }
      EXPECT_LE(deviation({move}, found->second), tolerance) << "line " << found->second.front().line;
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

/// Step of the default decimals, mm.
double step_of(const std::string& dialect, bool inch) {
  const bool coarse = dialect == "fanuc" || dialect == "haas" || dialect == "heidenhain";
  return (inch ? 25.4e-5 : 1e-4) * (coarse ? 10 : 1);
}

TEST_P(RoundTrip, RandomToolpathsComeBack) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const bool inch = seed % 2 == 0;
    const Toolpath toolpath = RandomPath(seed).toolpath(1 + static_cast<int>(seed % 7), 30);
    const std::string text = post(toolpath, Part{}, options_for(GetParam(), inch));
    const Program program = read_gcode(text, "random");
    EXPECT_TRUE(program.ended);
    expect_joined(program.toolpath);
    const double step = step_of(GetParam(), inch);
    expect_same(toolpath, program.toolpath, 3 * step + Tolerances{}.chord, 2 * step);
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Dialects, RoundTrip, ::testing::ValuesIn(post_dialects()));

TEST(LinuxCnc, InterpreterTakesRandomPrograms) {
  CLEARCUT_SKIP_WITHOUT_RS274();
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Toolpath toolpath = RandomPath(seed).toolpath(4, 100);
    const std::string text = post(toolpath, Part{}, options_for("linuxcnc", seed % 2 == 0));
    const testing::CanonProgram canon = testing::run_rs274(text);
    ASSERT_TRUE(canon.accepted) << canon.message;
    EXPECT_GT(canon.moves.size(), 300U);
  }
}

TEST(Post, RefusesUnknownDialectsAndNumbersThatAreNone) {
  Toolpath toolpath = RandomPath(1).toolpath(1, 3);
  EXPECT_THROW(post(toolpath, Part{}, options_for("basic", false)), InputError);
  for (const double bad : {std::nan(""), HUGE_VAL, 1e9}) {
    Toolpath broken = toolpath;
    broken.sections[0].moves[0].path.from.x = bad;
    EXPECT_THROW(post(broken, Part{}, options_for("linuxcnc", false)), InputError) << bad;
  }
}

}  // namespace
}  // namespace clearcut
