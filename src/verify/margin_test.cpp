#include "verify/margin.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

#include "verify/test_program.h"
#include "verify/verify.h"

namespace clearcut::verify {
namespace {

using clearcut::testing::cut_square_rings;
using clearcut::testing::pocket_part;
using clearcut::testing::rectangle;
using clearcut::testing::Writer;
using ::testing::Contains;

constexpr double kFloor = -3;

Part square_pocket() {
  return pocket_part(rectangle(-20, -20, 20, 20), 8, kFloor);
}

/// Rings that leave `wall` mm on the walls and `floor` mm on the floor.
Toolpath rings(double wall, double floor) {
  Writer writer;
  cut_square_rings(writer, {0, 0}, {0.5, 5, 10, 16 - wall}, 0, kFloor + floor);
  return writer.done();
}

Margin margin(const Toolpath& program, const MarginBounds& bounds) {
  return margin_of(square_pocket(), program, {}, bounds);
}

/// Whether the bounds hold of a program.
bool holds(const Toolpath& program, const MarginBounds& bounds) {
  VerifyOptions options;
  options.tol.uncut = bounds.uncut;
  options.tol.gouge = bounds.gouge;
  const Findings findings = verify_program(square_pocket(), program, options);
  return findings.all.uncut_thickness_mm <= bounds.uncut && findings.all.gouge_mm <= bounds.gouge;
}

struct Shift {
  Vec2 xy;
  double z = 0;
};

/// The program with each of its vertices moved.
template <typename ShiftOf>
Toolpath moved(Toolpath program, ShiftOf shift_of) {
  Shift at = shift_of();
  for (Section& section : program.sections) {
    for (Move& move : section.moves) {
      const Shift next = shift_of();
      move.path = Edge::line(move.path.from + at.xy, move.path.to + next.xy);
      move.z_from += at.z;
      move.z_to += next.z;
      at = next;
    }
  }
  return program;
}

TEST(Margin, IsWhatIsSparedOnWallsAndFloor) {
  // What is left on walls counts the root of two times in their corners.
  const struct {
    double wall, floor, uncut, gouge;
  } rows[] = {{0.004, 0.006, 0.03, 0.02}, {0.004, 0.006, 0.04, 0.01},   {0.006, 0.002, 0.04, 0.01},
              {0.012, 0.012, 0.02, 0.01}, {0, 0, 0.01, 0.001},          {0.0045, 0.0045, 0.01, 0.001},
              {0.001, 0.008, 0.01, 0.05}, {0.0038, 0.0038, 0.01, 0.001}};
  for (const auto& row : rows) {
    const Margin found = margin(rings(row.wall, row.floor), {row.uncut, row.gouge});
    ASSERT_EQ(found.features.size(), 1U);
    const double left = row.uncut - std::max(std::sqrt(2) * row.wall, row.floor);
    const double cut = row.gouge + std::min(row.wall, row.floor);
    EXPECT_NEAR(found.least()->mm, std::min(left, cut), 1.01 * kMarginStep) << row.wall << " " << row.floor;
    EXPECT_EQ(found.least()->feature, "POCKET");
    EXPECT_EQ(found.least()->limit, left < cut ? MarginLimit::kUncut : MarginLimit::kGouge) << row.wall;
  }
}

TEST(Margin, IsNothingWhereTheProgramItselfLeavesOrCutsTooMuch) {
  EXPECT_EQ(margin(rings(0.03, 0), {0.01, 0.001}).least()->mm, 0);
  EXPECT_EQ(margin(rings(-0.01, 0), {0.01, 0.001}).least()->mm, 0);
}

TEST(Margin, BetweenPassesCountsTwice) {
  // Passes 8 - 0.01 mm apart between long walls: either may be 0.005 mm off before something stands between them, and 0.01 more.
  const Part part = pocket_part(rectangle(-60, -7.995, 60, 7.995), 8, kFloor);
  Writer writer;
  writer.enter({-56, -3.995}, 0, kFloor)
      .feed({56, -3.995})
      .feed({56, 3.995})
      .feed({-56, 3.995})
      .feed({-56, -3.995});
  const Margin found = margin_of(part, writer.done(), {}, {0.02, 0.5});
  EXPECT_NEAR(found.least()->mm, 0.0125, 0.0026)
      << "a width of 0.02 - 0.01 mm of two passes, each 0.005 mm nearer";
  EXPECT_EQ(found.least()->limit, MarginLimit::kUncut);
}

TEST(Margin, HoldsOfProgramsThatAreThatFarOff) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int i = 0; i < 6; ++i) {
    const MarginBounds bounds{0.02, 0.01};
    const Toolpath program = rings(0.004 + 0.001 * (i % 4), 0.005);
    const double off = margin(program, bounds).least()->mm;
    ASSERT_GT(off, 0.01);
    const auto within = [&] {
      Shift shift;
      do {
        shift = {{share(random), share(random)}, share(random)};
      } while (norm_squared(shift.xy) + shift.z * shift.z > 1);
      return Shift{off * shift.xy, off * shift.z};
    };
    EXPECT_TRUE(holds(moved(program, within), bounds)) << i;
    const Shift once = within();
    EXPECT_TRUE(holds(moved(program, [&] { return once; }), bounds)) << i;
  }
}

TEST(Margin, DoesNotHoldAFifthBeyondItInTheWorstDirection) {
  for (const double wall : {0.002, 0.004, 0.006, 0.009}) {
    const MarginBounds bounds{0.02, 0.01};
    const Toolpath program = rings(wall, wall);
    const double off = 1.2 * margin(program, bounds).least()->mm;
    const auto holds_at = [&](const Shift& shift) {
      return holds(moved(program, [&] { return shift; }), bounds);
    };
    const double aslant = off * std::sqrt(0.5);
    EXPECT_FALSE(holds_at({{off, 0}, 0}) && holds_at({{aslant, aslant}, 0}) && holds_at({{0, 0}, off}))
        << wall;
  }
}

/// Of 24 directions in space.
Shift direction_number(int i) {
  const double angle = 0.7853981633974483 * (i % 8),
               up = i < 8    ? 0
                    : i < 16 ? 1
                             : -1,
               level = up == 0 ? 1 : 0.5;
  const double size = std::sqrt(level * level + up * up);
  return {{level * std::cos(angle) / size, level * std::sin(angle) / size}, up / size};
}

TEST(Margin, OfRandomProgramsHoldsAndIsNoSmallerThanItMustBe) {
  // CLEARCUT_RANDOM_PARTS: how many programs, else a few.
  const char* const set = std::getenv("CLEARCUT_RANDOM_PARTS");
  const int count = set ? std::atoi(set) : 3;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0, 1), both(-1, 1);
  int broken = 0, programs = 0, beyond = 0;
  while (programs < count) {
    const MarginBounds bounds{0.012 + 0.02 * share(random), 0.001 + 0.02 * share(random)};
    const double floor = 0.008 * share(random), wall = 0.008 * share(random);
    Writer writer;
    cut_square_rings(writer, {0, 0}, {0.5 + share(random), 5 + share(random), 10 + share(random), 16 - wall},
                     0, kFloor + floor);
    const Toolpath program = writer.done();
    const double off = margin(program, bounds).least()->mm;
    if (off < 0.001) continue;
    ++programs;
    const auto within = [&] {
      Shift shift;
      do {
        shift = {{both(random), both(random)}, both(random)};
      } while (norm_squared(shift.xy) + shift.z * shift.z > 1);
      return Shift{off * shift.xy, off * shift.z};
    };
    broken += holds(moved(program, within), bounds) ? 0 : 1;
    const Shift once = within();
    broken += holds(moved(program, [&] { return once; }), bounds) ? 0 : 1;
    bool holds_beyond = true;
    for (const int i : {1, 3, 5, 7, 8, 16, 0, 2, 4, 6, 9, 11, 13, 15, 17, 19, 21, 23}) {
      const Shift shift = direction_number(i);
      holds_beyond = holds_beyond && holds(moved(program,
                                                 [&] {
                                                   return Shift{1.2 * off * shift.xy, 1.2 * off * shift.z};
                                                 }),
                                           bounds);
    }
    beyond += holds_beyond ? 0 : 1;
  }
  std::cout << programs << " programs, " << broken << " of " << 2 * programs << " broken at the margin, "
            << beyond << " broken at 1.2 of it in its worst direction\n";
  EXPECT_EQ(broken, 0);
  EXPECT_GE(beyond * 10, programs * 9);
}

TEST(Margin, IsNotSaidOfLeaningWalls) {
  Part part = square_pocket();
  part.features[0].wall_slope = Radians::of(0.2);
  const Margin found = margin_of(part, rings(0, 0), {}, {});
  EXPECT_EQ(found.least(), nullptr);
  EXPECT_THAT(found.not_asked, Contains("POCKET"));
}

}  // namespace
}  // namespace clearcut::verify
