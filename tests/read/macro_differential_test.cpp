// Random programs with parameters, expressions, subroutines and loops beside LinuxCNC's own interpreter.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <optional>

#include "base/error.h"
#include "read/gcode/gcode.h"
#include "support/independent/rs274.h"
#include "support/random/random_macros.h"

namespace clearcut {
namespace {

/// mm; the interpreter prints four decimals.
constexpr double kPrinted = 4e-4;

/// More by hand: CLEARCUT_MACRO_PROGRAMS=2000.
int programs_asked() {
  const char* const asked = std::getenv("CLEARCUT_MACRO_PROGRAMS");
  return asked ? std::atoi(asked) : 50;
}

Program read_as_linuxcnc(const std::string& text) {
  read::gcode::ReadControllerOptions options;
  options.dialect = Dialect::kLinuxCnc;
  options.places = MachinePlaces{};
  return read::gcode::read_gcode(text, "random.ngc", options);
}

struct End {
  bool is_rapid = false;
  Vec2 place;
  double z = 0;
};

double apart(const End& a, const End& b) {
  return std::hypot(distance(a.place, b.place), a.z - b.z);
}

/// Ends of all moves, those of arcs included. Moves that stay where they are within what is printed say nothing.
std::vector<End> without_standstill(const std::vector<End>& ends) {
  std::vector<End> kept;
  for (const End& end : ends)
    if (kept.empty() || apart(kept.back(), end) > 3 * kPrinted) kept.push_back(end);
  return kept;
}

/// The number of the first end that differs; nothing where all are met in order. An arc of ours may come in several pieces.
std::optional<std::size_t> first_difference(const std::vector<End>& canon, const std::vector<Move>& moves) {
  std::size_t next = 0;
  for (std::size_t k = 0; k < canon.size(); ++k) {
    bool met = false;
    for (int pieces = 0; !met && pieces < 60 && next < moves.size(); ++pieces, ++next) {
      const Move& move = moves[next];
      const End end{is_rapid(move.kind), move.path.to, move.z_to};
      met = end.is_rapid == canon[k].is_rapid && apart(end, canon[k]) < 2 * kPrinted;
      if (!met && !move.path.is_arc() && move.length() > 4 * kPrinted) return k;
    }
    if (!met) return k;
  }
  return std::nullopt;
}

std::string difference(const test_support::CanonProgram& canon, const Toolpath& toolpath) {
  std::vector<End> ends;
  for (const test_support::CanonMove& move : canon.moves) ends.push_back({move.rapid, move.to, move.z});
  std::vector<Move> moves;
  for (const Section& section : toolpath.sections)
    moves.insert(moves.end(), section.moves.begin(), section.moves.end());
  const std::vector<End> kept = without_standstill(ends);
  const auto found = first_difference(kept, moves);
  if (!found) return "";
  return "move " + std::to_string(*found) + " to " + std::to_string(kept[*found].place.x) + " " +
         std::to_string(kept[*found].place.y) + " " + std::to_string(kept[*found].z);
}

TEST(MacrosBesideLinuxCnc, RandomProgramsMoveAlike) {
  CLEARCUT_SKIP_WITHOUT_RS274();
  int taken = 0;
  const int programs = programs_asked();
  for (int seed = 1; seed <= programs; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::string text = test_support::random_macro_program(static_cast<std::uint64_t>(seed));
    try {
      const Program program = read_as_linuxcnc(text);
      const test_support::CanonProgram canon = test_support::run_rs274(text);
      ASSERT_TRUE(canon.accepted) << canon.message << text;
      ASSERT_EQ(difference(canon, program.toolpath), "") << text;
      ++taken;
    } catch (const InputError& error) {
      ASSERT_FALSE(test_support::run_rs274(text).accepted) << error.what() << "\n" << text;
    }
  }
  EXPECT_GT(taken, programs * 8 / 10);
}

}  // namespace
}  // namespace clearcut
