#include "verify/program/checked_move.h"

#include <gtest/gtest.h>

#include "verify/test_findings.h"

namespace clearcut::verify {
namespace {

using testing::square_part;
using testing::square_program;

const std::vector<double> kRingsOfSquares{2, 5, 8, 11, 14, 17, 20};

/// s of the whole program as that control's, under that mode of the path.
double seconds(MotionPlanner planner, const PathControl& path) {
  const Toolpath toolpath = square_program(kRingsOfSquares);
  ControlTable control;
  control.planner = planner;
  ControlState state;
  state.path = path;
  control.spans.push_back({0, 1, state});
  double sum = 0;
  for (const CheckedMove& move : checked_program(square_part(), toolpath, {}, nullptr, &control).moves)
    sum += move.time_s;
  return sum;
}

TEST(CheckedMove, TimesAreThoseOfTheControl) {
  const PathControl within{PathMode::kTolerance, 0.01, {}}, exact{PathMode::kExactPath, {}, {}};
  // LinuxCNC stops at every corner under G61; Grbl knows no such word.
  EXPECT_GT(seconds(MotionPlanner::kLinuxCnc, exact), seconds(MotionPlanner::kLinuxCnc, within) + 0.1);
  EXPECT_EQ(seconds(MotionPlanner::kGrbl, exact), seconds(MotionPlanner::kGrbl, within));
  EXPECT_GT(seconds(MotionPlanner::kJerkLimited, {PathMode::kExactStop, {}, {}}),
            seconds(MotionPlanner::kLinuxCnc, exact));
}

TEST(CheckedMove, AMachineOfItsOwnGoesBeforeTheControl) {
  const Toolpath toolpath = square_program(kRingsOfSquares);
  Machine machine;
  machine.axis_acceleration = AxisValues{500, 50, 50};
  ControlTable control;
  control.planner = MotionPlanner::kGrbl;
  const auto sum = [&](const Machine& one) {
    double seconds = 0;
    for (const CheckedMove& move : checked_program(square_part(), toolpath, one, nullptr, &control).moves)
      seconds += move.time_s;
    return seconds;
  };
  EXPECT_GT(sum(machine), 1.1 * sum({}));
}

}  // namespace
}  // namespace clearcut::verify
