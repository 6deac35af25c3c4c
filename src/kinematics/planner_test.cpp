#include "kinematics/planner.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/elementary.h"

namespace clearcut::kinematics {
namespace {

Move cut(Vec2 from, Vec2 to, double mm_per_min) {
  return {Edge::line(from, to), 0, 0, MoveKind::kCut, MmPerMin::of(mm_per_min), 0};
}

Move cut_arc(Vec2 from, Vec2 to, Vec2 center, double mm_per_min) {
  return {Edge::arc(from, to, center, Turn::kCounterClockwise),
          0,
          0,
          MoveKind::kCut,
          MmPerMin::of(mm_per_min),
          0};
}

Move rapid(Vec2 from, Vec2 to) {
  return {Edge::line(from, to), 0, 0, MoveKind::kRapid, MmPerMin::of(0), 0};
}

Move rapid_down(double from, double to) {
  return {Edge::line({0, 0}, {0, 0}), from, to, MoveKind::kRapid, MmPerMin::of(0), 0};
}

constexpr PathControl kExact{PathMode::kExactPath, {}, {}};
constexpr PathControl kStop{PathMode::kExactStop, {}, {}};
constexpr PathControl kOpen{PathMode::kContinuous, {}, {}};

PathControl within(double mm) {
  return {PathMode::kTolerance, mm, std::nullopt};
}

double seconds(const std::vector<Move>& moves, const PathControl& path, MotionPlanner planner,
               const Machine& machine = {}) {
  return planned_time(moves, path, machine, planner).seconds();
}

/// s; rest to rest at `speed` and `a`.
double trapezoid(double length, double speed, double a) {
  return length < speed * speed / a ? 2 * std::sqrt(length / a) : length / speed + speed / a;
}

/// s that LinuxCNC takes longer for every standstill.
constexpr double kHalfCycle = 0.0005;

/// s that a planner takes longer for every standstill, besides braking.
double standstill(MotionPlanner planner) {
  return planner == MotionPlanner::kJerkLimited ? 0.05 : planner == MotionPlanner::kLinuxCnc ? kHalfCycle : 0;
}

const std::vector<MotionPlanner> kAll{MotionPlanner::kGrbl, MotionPlanner::kLinuxCnc, MotionPlanner::kMarlin,
                                      MotionPlanner::kMach, MotionPlanner::kJerkLimited};

TEST(Planner, OneLongMoveIsATrapezoidForEveryControlButForItsBell) {
  const std::vector<Move> moves{cut({0, 0}, {100, 0}, 3600)};
  const double plain = trapezoid(100, 60, 500);
  for (const MotionPlanner planner : kAll) {
    EXPECT_NEAR(seconds(moves, kStop, planner), plain + standstill(planner), 1e-9) << name_of(planner);
  }
}

TEST(Planner, NoControlIsFasterThanProgrammed) {
  const std::vector<Move> moves{cut({0, 0}, {30, 0}, 1000), cut({30, 0}, {30, 30}, 2000),
                                cut_arc({30, 30}, {10, 30}, {20, 30}, 1500), cut({10, 30}, {0, 0}, 500)};
  double naive = 0;
  for (const Move& move : moves) naive += move.length() / move.feed.mm_per_s();
  for (const MotionPlanner planner : kAll)
    EXPECT_GT(seconds(moves, within(0.01), planner), naive) << name_of(planner);
}

TEST(Planner, MovesOfNoLengthTakeNoTime) {
  const std::vector<Move> moves{cut({5, 5}, {5, 5}, 1000)};
  for (const MotionPlanner planner : kAll) EXPECT_EQ(seconds(moves, kStop, planner), 0) << name_of(planner);
}

TEST(Planner, EachAxisHasItsOwnLimits) {
  Machine machine;
  machine.axis_acceleration = AxisValues{500, 250, 100};
  machine.axis_rapid = AxisValues{6000, 3000, 600};
  for (const MotionPlanner planner : {MotionPlanner::kGrbl, MotionPlanner::kLinuxCnc, MotionPlanner::kMach}) {
    const double more = standstill(planner);
    EXPECT_NEAR(seconds({rapid({0, 0}, {100, 0})}, kStop, planner, machine), trapezoid(100, 100, 500) + more,
                1e-9);
    EXPECT_NEAR(seconds({rapid({0, 0}, {0, 100})}, kStop, planner, machine), trapezoid(100, 50, 250) + more,
                1e-9);
    EXPECT_NEAR(seconds({rapid_down(0, -20)}, kStop, planner, machine), trapezoid(20, 10, 100) + more, 1e-9);
    // Along (2, 1) both axes are at their limits together.
    EXPECT_NEAR(seconds({rapid({0, 0}, {100, 50})}, kStop, planner, machine),
                trapezoid(std::sqrt(12500.0), std::sqrt(12500.0), 250 * std::sqrt(5.0)) + more, 1e-9);
  }
}

TEST(Planner, MachineFileGoesBeforeTheControl) {
  Machine machine;
  EXPECT_EQ(planner_in_force(machine, {}), MotionPlanner::kGrbl);
  EXPECT_EQ(planner_in_force(machine, MotionPlanner::kMach), MotionPlanner::kMach);
  machine.planner = MotionPlanner::kLinuxCnc;
  EXPECT_EQ(planner_in_force(machine, MotionPlanner::kMach), MotionPlanner::kLinuxCnc);
}

TEST(Planner, GrblRunsArcsAsChords) {
  // v^2 = a d s / (1 - s) between chords within 0.002 mm: about 5 a r, here above the feed of 50 mm/s; as one arc 31.6 mm/s.
  const std::vector<Move> moves{cut({-50, -2}, {0, -2}, 3000), cut_arc({0, -2}, {0, 2}, {0, 0}, 3000),
                                cut({0, 2}, {-50, 2}, 3000)};
  EXPECT_NEAR(seconds(moves, kExact, MotionPlanner::kGrbl), trapezoid(100 + 2 * kPi, 50, 500), 2e-3);
  EXPECT_GT(seconds(moves, kStop, MotionPlanner::kMach), trapezoid(100 + 2 * kPi, 50, 500) + 0.1);
}

TEST(Planner, GrblRunsArcsAsWideAsItsToleranceInFewSteps) {
  // The number of chords by the tolerance has a pole where the diameter is the tolerance.
  const double r = std::nextafter(Machine{}.arc_tolerance / 2, 1);
  const std::vector<Move> moves{cut({-1, -r}, {0, -r}, 3000), cut_arc({0, -r}, {0, r}, {0, 0}, 3000)};
  EXPECT_NEAR(seconds(moves, kExact, MotionPlanner::kGrbl), trapezoid(1, 50, 500), 1e-2);
}

TEST(Planner, GrblSeesNoMoreThanItsBlocks) {
  // 16 blocks of 0.01 mm let it stop from no more than 12 mm/s.
  std::vector<Move> moves;
  for (int i = 0; i < 5000; ++i) moves.push_back(cut({i * 0.01, 0}, {(i + 1) * 0.01, 0}, 3600));
  EXPECT_NEAR(seconds(moves, kExact, MotionPlanner::kGrbl), 50 / std::sqrt(2 * 500 * 0.15), 0.15);
  EXPECT_LT(seconds(moves, kExact, MotionPlanner::kJerkLimited), trapezoid(50, 60, 500) + 0.0501);
}

TEST(Planner, LinuxCncStopsUnderG61AndBlendsUnderG64) {
  const std::vector<Move> moves{cut({0, 0}, {50, 0}, 3000), cut({50, 0}, {50, 50}, 3000)};
  // The acceleration of moves that meet at a corner is 0.9 of the whole, of the last under G64 half of it.
  EXPECT_NEAR(seconds(moves, kExact, MotionPlanner::kLinuxCnc), 2 * trapezoid(50, 50, 450) + 2 * kHalfCycle,
              1e-9);
  EXPECT_NEAR(seconds(moves, kStop, MotionPlanner::kLinuxCnc), 2 * trapezoid(50, 50, 500) + 2 * kHalfCycle,
              1e-9);
  // 90 degrees within P 0.01: R = P / (sqrt(2) - 1), v^2 = 0.866 a R: 3.2 mm/s.
  const double r = 0.01 / (std::sqrt(2.0) - 1), v = std::sqrt(std::sqrt(0.75) * 500 * r);
  const double slowing = (50 - v) * (50 - v) / (2 * 50);
  const double first = (50 - r) / 50 + 50 / (2 * 500.0) + slowing / 500;
  const double second = (50 - r) / 50 + 50 / (2 * 250.0) + slowing / 250;
  EXPECT_NEAR(seconds(moves, within(0.01), MotionPlanner::kLinuxCnc),
              first + kPi / 2 * r / v + second + kHalfCycle, 1e-6);
  EXPECT_LT(seconds(moves, within(0.05), MotionPlanner::kLinuxCnc),
            seconds(moves, within(0.01), MotionPlanner::kLinuxCnc));
}

TEST(Planner, LinuxCncStopsBetweenRapidsAndFeeds) {
  const std::vector<Move> moves{rapid({0, 0}, {50, 0}), cut({50, 0}, {100, 0}, 3000)};
  EXPECT_NEAR(seconds(moves, within(0.01), MotionPlanner::kLinuxCnc),
              trapezoid(50, 5000 / 60.0, 500) + trapezoid(50, 50, 250) + 2 * kHalfCycle, 1e-9);
}

TEST(Planner, LinuxCncShiftsAccelerationOnTightArcs) {
  // r = 5: v^2 = 0.866 a r = 46.5 mm/s below the feed, and half of the acceleration is left along the arc.
  const std::vector<Move> moves{cut_arc({5, 0}, {-5, 0}, {0, 0}, 3000)};
  const double v = std::sqrt(std::sqrt(0.75) * 500 * 5);
  EXPECT_NEAR(seconds(moves, kStop, MotionPlanner::kLinuxCnc), trapezoid(5 * kPi, v, 250) + kHalfCycle, 1e-6);
}

TEST(Planner, MachKeepsItsSpeedInConstantVelocity) {
  const std::vector<Move> moves{cut({0, 0}, {50, 0}, 3000), cut({50, 0}, {50, 50}, 3000)};
  EXPECT_NEAR(seconds(moves, kOpen, MotionPlanner::kMach), 100 / 50.0 + 0.1, 1e-9);
  EXPECT_NEAR(seconds(moves, kExact, MotionPlanner::kMach), 2 * trapezoid(50, 50, 500), 1e-9);
}

TEST(Planner, JerkBuildsAccelerationUp) {
  const std::vector<Move> moves{cut({0, 0}, {50, 0}, 3000), cut({50, 0}, {50, 50}, 3000)};
  Machine machine;
  machine.jerk = 5000;
  EXPECT_NEAR(seconds(moves, kStop, MotionPlanner::kJerkLimited, machine), 2 * (trapezoid(50, 50, 500) + 0.1),
              1e-9);
  EXPECT_LT(seconds(moves, within(0.05), MotionPlanner::kJerkLimited, machine),
            seconds(moves, within(0.01), MotionPlanner::kJerkLimited, machine));
}

TEST(Planner, MarlinByJunctionDeviationOrJerk) {
  const std::vector<Move> moves{cut({0, 0}, {50, 0}, 3000), cut({50, 0}, {50, 50}, 3000)};
  Machine machine;
  const double deviated = seconds(moves, kExact, MotionPlanner::kMarlin, machine);
  EXPECT_NEAR(deviated, seconds(moves, kExact, MotionPlanner::kGrbl, machine), 0.01);
  machine.speed_jump = AxisValues{10, 10, 0.3};
  EXPECT_LT(seconds(moves, kExact, MotionPlanner::kMarlin, machine), deviated);
}

TEST(Planner, LinuxCncRoundsACornerByTheFinerToleranceUnlessItsParabolaIsFaster) {
  // 200 lines of 5 mm at right angles, measured on LinuxCNC 2.9 from rest: 40.958 s under one G64 P0.005 and 53.287 s where
  // P0.05 and P0.005 take turns. Blend arcs keep to the finer one, so that every second corner is a parabola, beside
  // which both lines have half of the acceleration.
  std::vector<Move> moves;
  Vec2 at;
  for (int i = 0; i < 200; ++i) {
    const Vec2 to = i % 2 == 0 ? at + Vec2{5, 0} : at + Vec2{0, i % 4 == 1 ? 5.0 : -5.0};
    moves.push_back(cut(at, to, 3000));
    at = to;
  }
  Machine machine;
  machine.axis_rapid = AxisValues{5000, 5000, 5000};
  const auto time = [&](double odd, double even) {
    std::vector<PlannedMove> planned;
    for (std::size_t i = 0; i < moves.size(); ++i)
      planned.push_back({&moves[i], within(i % 2 == 0 ? odd : even), i == 0});
    double sum = 0;
    for (const Seconds one : planned_times(planned, machine, MotionPlanner::kLinuxCnc)) sum += one.seconds();
    return sum;
  };
  EXPECT_NEAR(time(0.05, 0.005) - time(0.005, 0.005), 53.936 - 41.607, 0.5);
}

TEST(Planner, StandstillBeforeAMoveIsKept) {
  const std::vector<Move> moves{cut({0, 0}, {50, 0}, 3000), cut({50, 0}, {100, 0}, 3000)};
  std::vector<PlannedMove> planned{{&moves[0], kExact, true}, {&moves[1], kExact, true}};
  for (const MotionPlanner planner : kAll) {
    double sum = 0;
    for (const Seconds time : planned_times(planned, {}, planner)) sum += time.seconds();
    EXPECT_NEAR(sum, 2 * trapezoid(50, 50, 500) + 2 * standstill(planner), 1e-6) << name_of(planner);
  }
}

}  // namespace
}  // namespace clearcut::kinematics
