// What is printed of a move, and that controls can only read it one way.
#include "post/words/steps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "post/words/comment.h"

namespace clearcut::post {
namespace {

std::string number(long long ticks, int decimals, bool point = false) {
  std::string text;
  append_number(text, ticks, decimals, point);
  return text;
}

TEST(PrintedNumbers, AreShortAndNeverMinusZero) {
  EXPECT_EQ(number(0, 4), "0");
  EXPECT_EQ(number(-0, 4), "0");
  EXPECT_EQ(number(125000, 4), "12.5");
  EXPECT_EQ(number(-1, 4), "-0.0001");
  EXPECT_EQ(number(-10000, 4), "-1");
  EXPECT_EQ(number(10000, 3, true), "10.");
  EXPECT_EQ(number(0, 3, true), "0.");
  EXPECT_EQ(number(123456789, 3), "123456.789");
}

TEST(PrintedNumbers, RoundToTheNearestStep) {
  const PrintGrid mm(false, 3), inch(true, 4);
  EXPECT_EQ(mm.ticks(1.2345), 1235);
  EXPECT_EQ(mm.ticks(-0.0004), 0);
  EXPECT_EQ(inch.ticks(25.4), 10000);
  EXPECT_DOUBLE_EQ(inch.mm(10000), 25.4);
}

Move arc_move(Vec2 center, double radius, double start, double sweep) {
  const Vec2 from = center + direction_of(start) * radius, to = center + direction_of(start + sweep) * radius;
  return {Edge::arc(from, to, center, sweep > 0 ? Turn::kCounterClockwise : Turn::kClockwise),
          0,
          -1,
          MoveKind::kCut,
          MmPerMin::of(100),
          0};
}

StepRules rules(int decimals) {
  return step_rules({}, decimals, 10000);
}

std::vector<Step> steps_of(const Move& move, const StepRules& r) {
  std::vector<Step> steps;
  append_steps(move, r.grid.ticks(move.path.from, move.z_from), r, steps);
  return steps;
}

TEST(Steps, RoundNumbersStayRound) {
  const auto steps = steps_of(arc_move({10, 0}, 10, kPi, -kPi / 2), rules(4));
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_EQ(steps[0].to, (Ticks{100000, 100000, -10000}));
  EXPECT_EQ(steps[0].i, 100000);
  EXPECT_EQ(steps[0].j, 0);
  EXPECT_EQ(steps[0].turn, Turn::kClockwise);
}

TEST(Steps, TinyFlatAndWideArcsBecomeLines) {
  for (const Move& move : {arc_move({0, 0}, 0.0009, 0, 3), arc_move({0, 0}, 5, 0, 0.001),
                           arc_move({0, 0}, 5, 0, 0.0015), arc_move({0, 0}, 20000, 0, 0.001)}) {
    const auto steps = steps_of(move, rules(4));
    ASSERT_FALSE(steps.empty());
    for (const Step& step : steps) EXPECT_EQ(step.turn, Turn::kStraight);
    EXPECT_EQ(steps.back().to, rules(4).grid.ticks(move.path.to, move.z_to));
  }
}

TEST(Steps, ArcsOfSomeGridStepsStayArcs) {
  const Move small = arc_move({0, 0}, 0.005, 0, 1.5);
  EXPECT_EQ(steps_of(small, rules(4)).back().turn, Turn::kCounterClockwise);
  EXPECT_EQ(steps_of(small, rules(3)).back().turn, Turn::kStraight);
}

TEST(Steps, PrintedRadiiAreNoTinierThanProofsTake) {
  Random random(5);
  int arcs = 0;
  for (int i = 0; i < 4000; ++i) {
    const Move move = arc_move({random.between(-9, 9), random.between(-9, 9)}, random.between(0.0019, 0.003),
                               random.between(0, 6), random.between(1.5, 4));
    std::vector<Step> steps;
    append_steps(move, rules(4).grid.ticks(move.path.from, move.z_from), rules(4), steps);
    for (const Step& step : steps) {
      if (step.turn == Turn::kStraight) continue;
      ++arcs;
      EXPECT_GE(std::hypot(static_cast<double>(step.i), static_cast<double>(step.j)), 20)
          << "steps of 0.1 um";
    }
  }
  EXPECT_GT(arcs, 500);
}

TEST(Steps, MotionThatRoundsToNothingIsLeftOut) {
  EXPECT_TRUE(steps_of({Edge::line({0, 0}, {0.00004, 0}), 0, 0, MoveKind::kCut, MmPerMin::of(1), 0}, rules(4))
                  .empty());
}

/// Two controls in one: centre form with radii compared at both ends, and the side and sweep that centre
/// gives.
TEST(Steps, PrintedArcsPassEveryControlsRule) {
  Random random(7);
  int arcs = 0;
  for (int n = 0; n < 20000; ++n) {
    const int decimals = 3 + static_cast<int>(random.below(3));
    const StepRules r = rules(decimals);
    const double radius = std::pow(10, random.between(-2.2, 4.2));
    const double sweep = random.between(0.001, 2 * kPi) * (random.below(2) == 0 ? 1 : -1);
    const Move move =
        arc_move({random.between(-99, 99), random.between(-99, 99)}, radius, random.between(0, 7), sweep);
    Ticks at = r.grid.ticks(move.path.from, move.z_from);
    double swept = 0;
    for (const Step& step : steps_of(move, r)) {
      if (step.turn != Turn::kStraight) {
        ++arcs;
        const Vec2 start{static_cast<double>(-step.i), static_cast<double>(-step.j)};
        const Vec2 end{static_cast<double>(step.to.x - at.x - step.i),
                       static_cast<double>(step.to.y - at.y - step.j)};
        EXPECT_LE(std::abs(norm(start) - norm(end)) * r.grid.step(), 0.002);
        EXPECT_FALSE(step.to.same_plan(at)) << "would be a full circle";
        EXPECT_EQ(step.turn, move.path.turn);
        swept += Edge::arc(start, end, {}, step.turn).sweep();
      }
      at = step.to;
    }
    EXPECT_EQ(at, r.grid.ticks(move.path.to, move.z_to));
    if (swept != 0 && steps_of(move, r).size() == 1) {
      EXPECT_NEAR(swept, sweep, 0.2);
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(arcs, 15000);
}

TEST(Comments, ArePlain) {
  EXPECT_EQ(plain_comment("Pocket (1)\n50% ~!?"), "POCKET 1 50. ...");
  EXPECT_EQ(plain_comment("MSG, hello, all"), "MSG: HELLO, ALL");
  EXPECT_EQ(plain_comment("T\xC3\xA4sch"), "T.SCH");
  EXPECT_EQ(operation_comment(3, "Pocket"), "OPERATION 3: POCKET");
  EXPECT_EQ(operation_comment(0, ""), "OPERATION: ");
}

TEST(Comments, ProgramNumbers) {
  EXPECT_EQ(program_number("O1234"), 1234);
  EXPECT_EQ(program_number("77"), 77);
  EXPECT_EQ(program_number("fishhead"), 1);
  EXPECT_EQ(program_number("0"), 1);
}

TEST(Comment, NamesToolsInTheUnitOfTheProgram) {
  Part part;
  Tool mill;
  mill.number = 1;
  mill.kind = ToolKind::kEndMill;
  mill.diameter = 6.35;
  Tool bit = mill;
  bit.number = 2;
  bit.kind = ToolKind::kVBit;
  bit.diameter = 10;
  bit.tip_angle = Radians::of_degrees(60);
  bit.tip_diameter = 0.4;
  part.tools = {mill, bit};
  EXPECT_EQ(tool_change_comment(part, 1, false), "TOOL CHANGE T1: ENDMILL D6.35 MM");
  EXPECT_EQ(tool_change_comment(part, 1, true), "TOOL CHANGE T1: ENDMILL D0.25 IN");
  EXPECT_EQ(tool_change_comment(part, 2, false), "TOOL CHANGE T2: VBIT D10 MM 60 DEG TIP 0.4 MM");
  EXPECT_EQ(tool_change_comment(part, 2, true),
            "TOOL CHANGE T2: VBIT D0.3937 IN = 10 MM 60 DEG TIP 0.0157 IN = 0.4 MM");
}

Move line_move(Vec2 from, double z_from, Vec2 to, double z_to, MoveKind kind, double feed) {
  return {Edge::line(from, to), z_from, z_to, kind, MmPerMin::of(feed), 0};
}

TEST(JoinedLines, AreThoseThatGoOnInOneDirectionAtOneFeed) {
  const PrintGrid grid(false, 3);
  const std::vector<Move> moves = {line_move({0, 0}, 5, {0, 0}, 1, MoveKind::kRapid, 0),
                                   line_move({0, 0}, 1, {0, 0}, 0.2, MoveKind::kPlunge, 300),
                                   line_move({0, 0}, 0.2, {0, 0}, -3, MoveKind::kPlunge, 300),
                                   line_move({0, 0}, -3, {2, 4}, -3, MoveKind::kLink, 900),
                                   line_move({2, 4}, -3, {3, 6}, -3, MoveKind::kCut, 900),
                                   line_move({3, 6}, -3, {5, 10}, -3, MoveKind::kCut, 600),
                                   line_move({5, 10}, -3, {3, 6}, -3, MoveKind::kCut, 600)};
  const std::vector<Move> joined = with_lines_joined(moves, grid);
  ASSERT_EQ(joined.size(), 5U);
  EXPECT_EQ(joined[1].z_from, 1);
  EXPECT_EQ(joined[1].z_to, -3);
  EXPECT_EQ(joined[2].path.to, (Vec2{3, 6}));
  EXPECT_EQ(joined[4].path.to, (Vec2{3, 6}));
}

TEST(JoinedLines, AreNeitherBentByAStepNorSlantingRapids) {
  const PrintGrid grid(false, 3);
  const std::vector<Move> bent = {line_move({0, 0}, 0, {10, 0}, 0, MoveKind::kCut, 300),
                                  line_move({10, 0}, 0, {20, 0.001}, 0, MoveKind::kCut, 300)};
  EXPECT_EQ(with_lines_joined(bent, grid).size(), 2U);
  const std::vector<Move> slanting = {line_move({0, 0}, 0, {1, 0}, 1, MoveKind::kRapid, 0),
                                      line_move({1, 0}, 1, {2, 0}, 2, MoveKind::kRapid, 0)};
  EXPECT_EQ(with_lines_joined(slanting, grid).size(), 2U);
}

}  // namespace
}  // namespace clearcut::post
