// Random contours with G41, G42, G41.1 and G42.1 beside LinuxCNC's own interpreter.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <regex>

#include "base/error.h"
#include "base/random.h"
#include "base/units.h"
#include "geometry/vec2.h"
#include "read/gcode/gcode.h"
#include "support/independent/rs274.h"
#include "support/random/random_programs.h"

namespace clearcut {
namespace {

/// mm; the interpreter prints four decimals, and its arcs have two radii within the same error, which moves corners that are nearly
/// tangent by more.
constexpr double kPrinted = 2e-3;
/// Inches, of every tool in the interpreter's table; and the radius in mm.
constexpr double kDiameterInTable = 0.25, kRadiusInTable = 3.175;

/// More by hand: CLEARCUT_COMPENSATION_PROGRAMS=500.
int programs_asked() {
  const char* const asked = std::getenv("CLEARCUT_COMPENSATION_PROGRAMS");
  return asked ? std::atoi(asked) : 40;
}

/// Lines and arcs, tangent or with corners either way, rapids and heights between them.
class ContourWriter {
 public:
  explicit ContourWriter(std::uint64_t seed) : random_(seed) {}

  std::string program() {
    line("G21 G17 G90 G91.1 G94 G40 G49 G80 F200");
    line("T1 M6");
    line("G0 X0 Y0 Z5");
    for (int contours = 1 + any(2); contours > 0; --contours) contour();
    line("G0 Z9");
    line("M2");
    return text_;
  }

 private:
  bool chance(double share) { return random_.unit() < share; }
  int any(int n) { return static_cast<int>(random_.below(static_cast<std::uint64_t>(n))); }
  double between(double low, double high) { return low + (high - low) * random_.unit(); }
  void line(const std::string& words) { text_ += fmt::format("N{} {}\n", ++lines_, words); }

  void contour() {
    const bool left = chance(0.5);
    if (chance(0.5))
      line(fmt::format("G{} D1", left ? 41 : 42));
    else if (chance(0.3))
      line(fmt::format("G{}", left ? 41 : 42));
    else
      line(fmt::format("G{}.1 D{:.3f}", left ? 41 : 42, between(-1, 7)));
    heading_ = between(0, 2 * kPi);
    go(chance(0.1) ? between(0.5, 4) : between(7, 20), chance(0.2));
    // Corners that leave room more often than those that a control stops at.
    const double inside = left ? 1 : -1;
    for (int moves = 2 + any(7); moves > 0; --moves) {
      if (chance(0.3))
        heading_ += 0;
      else if (chance(0.5))
        heading_ -= inside * between(0, 3.1);
      else
        heading_ += inside * between(0, 1.6);
      if (chance(0.1)) line(fmt::format("Z{:.3f}", between(-3, 3)));
      if (chance(0.4))
        arc();
      else
        go(between(2, 25), chance(0.1));
    }
    if (chance(0.2)) line(fmt::format("G0 Z{:.3f}", between(4, 6)));
    line("G40");
    heading_ += between(-1, 1);
    if (chance(0.9)) go(between(5, 20), chance(0.5));
  }

  void go(double length, bool rapid) {
    to(at_ + direction_of(heading_) * length);
    line(fmt::format("G{} X{:.4f} Y{:.4f}{}", rapid ? 0 : 1, at_.x, at_.y, height()));
  }

  void arc() {
    const bool counter = chance(0.5);
    const double radius = chance(0.15) ? between(0.5, 4) : between(4, 18),
                 sweep = between(0.2, chance(0.2) ? 5.5 : 2);
    const double side = counter ? 1 : -1;
    const Vec2 center = rounded(at_ + left_of(direction_of(heading_)) * (side * radius));
    const Vec2 from = at_;
    heading_ += side * sweep;
    to(center - left_of(direction_of(heading_)) * (side * radius));
    line(fmt::format("G{} X{:.4f} Y{:.4f} I{:.4f} J{:.4f}{}", counter ? 3 : 2, at_.x, at_.y,
                     center.x - from.x, center.y - from.y, height()));
  }

  std::string height() { return chance(0.1) ? fmt::format(" Z{:.3f}", between(-3, 3)) : ""; }
  static Vec2 rounded(Vec2 p) { return {std::round(p.x * 1e4) / 1e4, std::round(p.y * 1e4) / 1e4}; }
  void to(Vec2 place) { at_ = rounded(place); }

  Random random_;
  std::string text_;
  int lines_ = 0;
  Vec2 at_;
  double heading_ = 0;
};

Program read_as_linuxcnc(const std::string& text) {
  read::gcode::ReadControllerOptions options;
  options.dialect = Dialect::kLinuxCnc;
  options.places = MachinePlaces{};
  options.compensation.only_radius = kRadiusInTable;
  return read::gcode::read_gcode(text, "contour.ngc", options);
}

/// The interpreter says moves that waited under the number of the block that let them go: they are compared by their order alone.
std::string difference(const std::string& canon, Toolpath toolpath) {
  for (Section& section : toolpath.sections)
    for (Move& move : section.moves) move.line = 1;
  return test_support::difference_of_motion(std::regex_replace(canon, std::regex("N[0-9.]+ "), "N1 "),
                                            toolpath, kPrinted);
}

TEST(CompensationBesideLinuxCnc, RandomContoursMoveAlikeAndStopAlike) {
  CLEARCUT_SKIP_WITHOUT_RS274();
  int taken = 0;
  const int programs = programs_asked();
  for (int seed = 1; seed <= programs; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::string text = ContourWriter(static_cast<std::uint64_t>(seed)).program();
    const test_support::CanonProgram canon = test_support::run_rs274(text, kDiameterInTable);
    try {
      const Program program = read_as_linuxcnc(text);
      EXPECT_TRUE(canon.accepted) << canon.message << text;
      EXPECT_EQ(difference(canon.canon, program.toolpath), "") << text;
      ++taken;
    } catch (const InputError& error) {
      EXPECT_FALSE(canon.accepted) << error.what() << "\n" << text;
    }
  }
  EXPECT_GT(taken, programs / 5);
  ::testing::Test::RecordProperty("taken", taken);
  if (programs > 40) fmt::print("{} of {} contours are taken by both\n", taken, programs);
}

}  // namespace
}  // namespace clearcut
