#include "kinematics/kinematics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace clearcut::kinematics {
namespace {

Move feed_line(Vec2 from, Vec2 to, double mm_per_min) {
  return {Edge::line(from, to), 0, 0, MoveKind::kCut, MmPerMin::of(mm_per_min), 0};
}

Move feed_arc(Vec2 from, Vec2 to, Vec2 center, double mm_per_min) {
  return {Edge::arc(from, to, center, Turn::kCounterClockwise),
          0,
          0,
          MoveKind::kCut,
          MmPerMin::of(mm_per_min),
          0};
}

const Machine kMachine{};  // 500 mm/s2, 0.01 mm, rapid 5000 mm/min

TEST(Kinematics, LongMoveIsATrapezoid) {
  // 60 mm/s at 500 mm/s2: 0.12 s and 3.6 mm each to speed up and down; 92.8 mm at 60 mm/s between.
  const std::vector<Move> moves{feed_line({0, 0}, {100, 0}, 3600)};
  EXPECT_NEAR(kinematic_time(moves, kMachine).seconds(), 0.24 + 92.8 / 60, 1e-12);
}

TEST(Kinematics, ShortMoveIsATriangle) {
  const std::vector<Move> moves{feed_line({0, 0}, {2, 0}, 3600)};
  EXPECT_NEAR(kinematic_time(moves, kMachine).seconds(), 2 * std::sqrt(2.0 / 500), 1e-12);
}

TEST(Kinematics, CuttingAStraightMoveIntoPiecesChangesNothing) {
  std::vector<Move> pieces;
  for (int i = 0; i < 1000; ++i) pieces.push_back(feed_line({i * 0.1, 0}, {(i + 1) * 0.1, 0}, 3600));
  EXPECT_NEAR(kinematic_time(pieces, kMachine).seconds(), 0.24 + 92.8 / 60, 1e-6);
}

TEST(Kinematics, RightAngleSlowsToTheJunctionSpeed) {
  // s = sin(45 deg): v^2 = 500 * 0.01 * 0.70711 / 0.29289 = 12.0711
  const std::vector<Move> moves{feed_line({0, 0}, {100, 0}, 3600), feed_line({100, 0}, {100, 100}, 3600)};
  const double v = std::sqrt(12.071067811865476), a = 500;
  const double ramps = 60 / a + (60 - v) / a, ramp_mm = 60 * 60 / (2 * a) + (60 * 60 - v * v) / (2 * a);
  EXPECT_NEAR(kinematic_time(moves, kMachine).seconds(), 2 * (ramps + (100 - ramp_mm) / 60), 1e-9);
}

/// From v0 to v1 with `top` between, which is reached; at 500 mm/s2.
double seconds_of(double length, double v0, double top, double v1) {
  const double a = kMachine.acceleration;
  const double ramps = (2 * top * top - v0 * v0 - v1 * v1) / (2 * a);
  return (2 * top - v0 - v1) / a + (length - ramps) / top;
}

Move sloping(Move move, double z_from, double z_to) {
  move.z_from = z_from;
  move.z_to = z_to;
  return move;
}

TEST(Kinematics, CornersInSpaceSlowByTheAngleInSpace) {
  // (80, 60, -30) and then (60, 80, 20): 9000 is the product of their components.
  const std::vector<Move> moves{sloping(feed_line({0, 0}, {80, 60}, 3600), 5, -25),
                                sloping(feed_line({80, 60}, {140, 140}, 3600), -25, -5)};
  const double first = std::hypot(100, 30), second = std::hypot(100, 20);
  const double s = std::sqrt((1 + 9000 / (first * second)) / 2);
  const double v = std::sqrt(kMachine.acceleration * kMachine.junction_deviation * s / (1 - s));
  EXPECT_NEAR(kinematic_time(moves, kMachine).seconds(),
              seconds_of(first, 0, 60, v) + seconds_of(second, v, 60, 0), 1e-9);
}

TEST(Kinematics, HelicesAreAsFastAsTheirCurvatureInSpaceAllows) {
  // Half a turn of radius 20 that falls 30 mm, then level along its tangent in plan.
  const double plan = 20 * kPi, climb = 30 / plan, length = std::hypot(plan, 30.0);
  const double top = std::sqrt(kMachine.acceleration * 20 * (1 + climb * climb));
  const double s = std::sqrt((1 + plan / length) / 2);
  const double v = std::sqrt(kMachine.acceleration * kMachine.junction_deviation * s / (1 - s));
  const std::vector<Move> moves{sloping(feed_arc({0, -20}, {0, 20}, {0, 0}, 12000), 5, -25),
                                sloping(feed_line({0, 20}, {-300, 20}, 12000), -25, -25)};
  EXPECT_NEAR(kinematic_time(moves, kMachine).seconds(),
              seconds_of(length, 0, top, v) + seconds_of(300, v, 200, 0), 1e-9);
}

TEST(Kinematics, TheSlowerOfTwoMovesRulesBetweenThem) {
  const Move slow = feed_line({0, 0}, {100, 0}, 1800), fast = feed_line({100, 0}, {200, 0}, 3600);
  const double expected = seconds_of(100, 0, 30, 30) + seconds_of(100, 30, 60, 0);
  EXPECT_NEAR(kinematic_time(std::vector<Move>{slow, fast}, kMachine).seconds(), expected, 1e-9);
  const Move first = feed_line({0, 0}, {100, 0}, 3600), second = feed_line({100, 0}, {200, 0}, 1800);
  EXPECT_NEAR(kinematic_time(std::vector<Move>{first, second}, kMachine).seconds(), expected, 1e-9);
}

TEST(Kinematics, ReversalStops) {
  const std::vector<Move> there_and_back{feed_line({0, 0}, {100, 0}, 3600),
                                         feed_line({100, 0}, {0, 0}, 3600)};
  EXPECT_NEAR(kinematic_time(there_and_back, kMachine).seconds(), 2 * (0.24 + 92.8 / 60), 1e-9);
}

TEST(Kinematics, TangentArcDoesNotStopAndIsLimitedByItsCurvature) {
  // r = 2: v^2 = 500 * 2, far below 100 mm/s.
  const std::vector<Move> moves{feed_line({-50, -2}, {0, -2}, 6000), feed_arc({0, -2}, {0, 2}, {0, 0}, 6000),
                                feed_line({0, 2}, {-50, 2}, 6000)};
  const double v = std::sqrt(1000.0), arc = 2 * kPi / v;
  const auto times = move_times(moves, kMachine);
  EXPECT_NEAR(times[1].seconds(), arc, 1e-6);
  EXPECT_LT(times[0].seconds() + times[2].seconds(), 2 * (0.2 + 40.0 / 100) + 0.13);
}

TEST(Kinematics, LookAheadBrakesOverManyShortMoves) {
  // Ten moves of 0.5 mm before a dead end: 5 mm are enough to stop from 60 mm/s only when seen together.
  std::vector<Move> moves{feed_line({-100, 0}, {0, 0}, 3600)};
  for (int i = 0; i < 10; ++i) moves.push_back(feed_line({i * 0.5, 0}, {(i + 1) * 0.5, 0}, 3600));
  EXPECT_NEAR(kinematic_time(moves, kMachine).seconds(), 0.24 + (105 - 7.2) / 60, 1e-9);
}

TEST(Kinematics, RapidsAndMovesWithoutFeedRunAtRapid) {
  Move rapid = feed_line({0, 0}, {100, 0}, 0);
  const double as_feed = kinematic_time(std::vector<Move>{rapid}, kMachine).seconds();
  rapid.kind = MoveKind::kRapid;
  EXPECT_EQ(kinematic_time(std::vector<Move>{rapid}, kMachine).seconds(), as_feed);
  EXPECT_NEAR(naive_time(rapid, kMachine).seconds(), 100 / (5000 / 60.0), 1e-12);
}

TEST(Kinematics, MovesOfNoLengthAreHarmless) {
  Move nothing = feed_line({5, 5}, {5, 5}, 1000);
  EXPECT_EQ(kinematic_time(std::vector<Move>{nothing}, kMachine).seconds(), 0);
  EXPECT_EQ(kinematic_time(std::vector<Move>{}, kMachine).seconds(), 0);
}

/// From rest to rest: v / a to speed up and to brake, and a path too short for the speed in 2 sqrt(L / a).
TEST(Kinematics, TravelFromRestToRest) {
  EXPECT_NEAR(travel_time(100, 50, 500), 2 + 0.1, 1e-12);
  EXPECT_NEAR(travel_time(1.25, 50, 500), 0.1, 1e-12);
  EXPECT_EQ(travel_time(0, 50, 500), 0);
  // The speed is just reached on 5 mm; half a per cent more or less.
  EXPECT_NEAR(travel_time(5.025, 50, 500), 0.1 + 5.025 / 50, 1e-12);
  EXPECT_NEAR(travel_time(4.975, 50, 500), 2 * std::sqrt(4.975 / 500), 1e-12);
}

TEST(Kinematics, NeverFasterThanProgrammed) {
  const std::vector<Move> moves{feed_line({0, 0}, {30, 0}, 1000), feed_line({30, 0}, {30, 30}, 2000),
                                feed_line({30, 30}, {0, 0}, 500)};
  double naive = 0;
  for (const Move& move : moves) naive += naive_time(move, kMachine).seconds();
  EXPECT_GT(kinematic_time(moves, kMachine).seconds(), naive);
}

}  // namespace
}  // namespace clearcut::kinematics
