// Holes from drawings to certificates: spotted, pecked, reamed, bored, counterbored, countersunk, tapped, thread milled.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "base/random.h"
#include "pipeline/test_drawings.h"
#include "post/post.h"
#include "read/gcode/gcode.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string kBlock = box("STOCK_D12", -30, -30, 30, 30);
constexpr Vec2 kCenter{5, -3};

Part with_circle(const std::string& layer, double diameter, const std::string& more = "") {
  return drawn(kBlock + circle(layer, kCenter, diameter / 2) + more);
}

void expect_clean(const PlanResult& result) {
  EXPECT_TRUE(result.findings.all.clean) << faults_of(result.findings) << result.program;
}

/// The verdict on a program of a part in which one text is replaced.
Findings changed(const Part& part, const PlanResult& planned, const std::string& what, const std::string& by,
                 const PlanOptions& options, Dialect dialect = Dialect::kLinuxCnc) {
  std::string program = planned.program;
  const auto at = program.find(what);
  EXPECT_NE(at, std::string::npos) << what << "\n" << program;
  if (at != std::string::npos) program.replace(at, what.size(), by);
  return check_program(part, program, "changed", options, dialect).findings;
}

std::string warnings_of(const Part& part) {
  std::string text;
  for (const Diagnostic& one : part.diagnostics.items())
    if (one.severity == Severity::kWarning) text += one.what + "\n";
  return text;
}

TEST(HolePlan, AThroughHoleIsDrilledByItsPointBelowTheStock) {
  const Part part = with_circle("DRILL_D12", 6);
  const auto options = with({"drill:6"});
  const PlanResult result = plan_part(part, options);
  expect_clean(result);
  // 12 mm, 0.5 mm more, and 3 / tan 59 degrees.
  EXPECT_THAT(result.program, HasSubstr("Z-14.3026 R1 "));
  const Findings shallow = changed(part, result, "Z-14.3026", "Z-13", options);
  EXPECT_TRUE(has(shallow, FaultKind::kUncut)) << faults_of(shallow);
}

/// The point of a drill of 6 mm is 1.8 mm long: a hole 1 mm deep is nowhere 6 mm wide when the point ends on its floor.
TEST(HolePlan, AHoleShallowerThanThePointOfItsOnlyDrillIsOutOfReach) {
  const Part part = with_circle("DRILL_D1", 6, circle("POCKET_D3", {18, 18}, 9));
  PlanOptions options = with({"drill:6", "endmill:10"});
  const PlanResult result = plan_part(part, options);
  const CheckResult checked = check_program(part, result.program, "x", options);
  for (const Findings* findings : {&result.findings, &checked.findings}) {
    EXPECT_TRUE(findings->faults.empty()) << faults_of(*findings);
    ASSERT_FALSE(findings->conditions.empty());
    const auto& conditions = findings->conditions;
    const auto open = std::find_if(conditions.begin(), conditions.end(),
                                   [](const Condition& one) { return one.met_by.empty(); });
    ASSERT_NE(open, conditions.end());
    EXPECT_EQ(open->name, "out-of-reach");
    EXPECT_THAT(open->text, HasSubstr("ends in a point of 1.803 mm, and the hole is 1 mm deep"));
  }
  // A program that leaves a cone in it is no better for that.
  const Findings cone =
      changed(part, result, "M2", "G0 Z5\nT1 M6\nG43\nM3 S1000\nG0 X5 Y-3\nG1 Z-1 F100\nG0 Z5\nM2", options);
  EXPECT_TRUE(has(cone, FaultKind::kUncut)) << faults_of(cone);
  expect_clean(plan_part(part, with({"drill:6:118deg", "endmill:10"})));
}

/// Pecks and the dwell of an operation, as STEP-NC states them, in programs of others.
TEST(HolePlan, StatedPecksAndDwellsOfAnOperationAreMissedInOtherPrograms) {
  Part part = with_circle("DRILL_D10", 6);
  const auto options = with({"drill:6"});
  const auto names_of = [](const Findings& findings) {
    std::string names;
    for (const Condition& one : findings.conditions) names += one.name + " ";
    return names;
  };
  const PlanResult at_once = plan_part(part, options);
  part.workplan[0].operation.stepdown = 4;
  const PlanResult pecked = plan_part(part, options);
  expect_clean(pecked);
  EXPECT_THAT(pecked.program, HasSubstr("G83"));
  EXPECT_THAT(names_of(check_program(part, pecked.program, "own", options).findings),
              Not(HasSubstr("stated")));
  EXPECT_THAT(names_of(check_program(part, at_once.program, "other", options).findings),
              HasSubstr("stated-peck"));
  HoleFeeds feeds;
  feeds.dwell_s = 1.5;
  part.workplan[0].operation.stepdown.reset();
  part.workplan[0].operation.hole_feeds = feeds;
  const PlanResult waiting = plan_part(part, options);
  expect_clean(waiting);
  EXPECT_THAT(names_of(check_program(part, waiting.program, "own", options).findings),
              Not(HasSubstr("stated")));
  EXPECT_THAT(names_of(changed(part, waiting, "P1.5", "P0.5", options)), HasSubstr("stated-dwell"));
  EXPECT_THAT(names_of(check_program(part, at_once.program, "other", options).findings),
              HasSubstr("stated-dwell"));
}

/// 0.0001 inch is 2.54 um: this place is missed by 1.8 um, and the cutter is as wide as its hole.
TEST(HolePlan, APlaceThatTheDigitsOfInchesMissIsThePlace) {
  const Part part = drawn(kBlock + circle("DRILL_D5", {11.6243, 11.6243}, 3));
  auto options = with({"drill:6"});
  options.post.dialect = "haas";
  options.post.inch = true;
  const PlanResult result = plan_part(part, options);
  expect_clean(result);
  EXPECT_THAT(warnings_of(result.part), Not(HasSubstr("--decimals")));
  // 0.0003 inch more is 6.5 um beside the place.
  const Findings beside = changed(part, result, "G81 X0.4576", "G81 X0.4579", options, Dialect::kHaas);
  EXPECT_TRUE(has(beside, FaultKind::kGouge)) << faults_of(beside);
}

/// Taps go straight down as drills do, and boring bars take the walls that mills leave within these digits.
TEST(HolePlan, TappedAndBoredHolesMayLieBesideTheirPlacesAsDrilledOnesMay) {
  for (const char* dialect : {"fanuc", "heidenhain", "siemens"}) {
    SCOPED_TRACE(dialect);
    const auto in_inches = [&](const std::string& hole, const std::vector<std::string>& tools) {
      auto options = with(tools);
      options.post.dialect = dialect;
      options.post.inch = true;
      expect_clean(plan_part(drawn(kBlock + hole), options));
    };
    in_inches(circle("TAP_M6_D7", {15, 20}, 3), {"drill:5", "tap:M6:floating"});
    in_inches(circle("BORE_D6", {10, 20}, 7), {"endmill:4", "boringbar:14"});
  }
}

TEST(HolePlan, APlaceThatCoarserDigitsMissIsAFaultAndSaidWithWhatHelps) {
  const Part part = drawn(kBlock + circle("DRILL_D5", {11.6249, 11.6249}, 3));
  auto options = with({"drill:6"});
  options.post.decimals = 2;
  const PlanResult coarse = plan_part(part, options);
  EXPECT_TRUE(has(coarse.findings, FaultKind::kGouge)) << coarse.program;
  EXPECT_THAT(warnings_of(coarse.part), HasSubstr("add --decimals 3"));
}

/// Walls of a milled hole are no places: the same hole, bored by a mill, has its allowance of 0.001 mm.
TEST(HolePlan, AMilledHoleKeepsItsWall) {
  const Part part = drawn(kBlock + circle("POCKET_D5", {11, 11}, 4));
  const auto options = with({"endmill:6"});
  const PlanResult result = plan_part(part, options);
  expect_clean(result);
  EXPECT_THAT(result.program, HasSubstr("X12 "));
  std::string wide = result.program;
  for (auto at = wide.find("X12 "); at != std::string::npos; at = wide.find("X12 ", at + 1))
    wide.replace(at, 4, "X12.003 ");
  const Findings beside = check_program(part, wide, "wide", options, Dialect::kLinuxCnc).findings;
  EXPECT_TRUE(has(beside, FaultKind::kGouge)) << faults_of(beside);
}

/// A mill as wide as its slot has no more room than a drill: its middle, 25 mm, is missed by 1.2 um.
TEST(HolePlan, ASlotAsWideAsTheCutterThatTheDigitsMissIsSaidLikewise) {
  const Part part = drawn(box("STOCK_D12", -30, 0, 30, 50) +
                          outline("SLOT_D3", {{{-10, 22}}, {{10, 22}, 1}, {{10, 28}}, {{-10, 28}, 1}}));
  auto options = with({"endmill:6"});
  options.post.dialect = "haas";
  options.post.inch = true;
  const PlanResult coarse = plan_part(part, options);
  EXPECT_TRUE(has(coarse.findings, FaultKind::kGouge)) << coarse.program;
  EXPECT_THAT(warnings_of(coarse.part), HasSubstr("add --decimals 5"));
  options.post.decimals = 5;
  const PlanResult fine = plan_part(part, options);
  expect_clean(fine);
  EXPECT_THAT(warnings_of(fine.part), Not(HasSubstr("--decimals")));
}

/// A drill makes no other hole than one of its own size: what is wider is left and said, by plan and verify alike.
TEST(HolePlan, HolesThatNoDrillMakesAreNotDrilledNarrower) {
  const Part part = drawn(kBlock + circle("DRILL_D12", {5, -3}, 0.495) + circle("DRILL_D12", {10, -3}, 1.6) +
                          circle("DRILL_D12", {15, -3}, 1.6) + circle("DRILL_D12", {20, -3}, 1.52));
  const auto options = with({"drill:1", "drill:3"});
  const PlanResult planned = plan_part(part, options);
  expect_clean(planned);
  const auto open = [](const Findings& findings) {
    std::string text;
    for (const Condition& one : findings.conditions)
      if (one.met_by.empty()) text += one.name + " " + one.text + "\n";
    return text;
  };
  EXPECT_THAT(open(planned.findings),
              HasSubstr("(and 1 more): no tool at hand makes a hole of 3.2 mm; T2 (drill 3 mm) is narrower"));
  EXPECT_THAT(planned.program, Not(HasSubstr("X10 ")));
  EXPECT_THAT(planned.program, HasSubstr("X20 "));
  EXPECT_EQ(open(check_program(part, planned.program, "again", options, Dialect::kLinuxCnc).findings),
            open(planned.findings));
  // Drilled all the same it is a hole of the wrong width.
  const Findings narrow = changed(part, planned, "X20 Y-3 Z", "X10 Y-3 Z", options);
  EXPECT_TRUE(has(narrow, FaultKind::kUncut)) << faults_of(narrow);
}

TEST(HolePlan, ABlindHoleHasItsWidthToItsDepthWhereThePointIsKnown) {
  EXPECT_THAT(plan_part(with_circle("DRILL_D6", 6), with({"drill:6:90deg"})).program, HasSubstr("Z-9 R1 "));
  EXPECT_THAT(plan_part(with_circle("DRILL_D6", 6), with({"drill:6"})).program, HasSubstr("Z-6 R1 "));
}

TEST(HolePlan, AMilledHoleAcrossTheStocksEdgeLeavesItsAllowance) {
  const Part part = drawn(kBlock + circle("HOLE_D1", {1.5, -19.9}, 14.7));
  for (const char* strategy : {"contour", "zigzag"}) {
    auto options = with({"endmill:3"});
    options.strategy = strategy;
    options.allowance = 0.1;
    expect_clean(plan_part(part, options));
  }
}

TEST(HolePlan, PecksBreakOrClearTheChip) {
  const PlanResult chips = plan_part(with_circle("DRILL_D10_CHIP2.5", 4), with({"drill:4"}));
  expect_clean(chips);
  EXPECT_THAT(chips.program, HasSubstr("G98 G73 "));
  EXPECT_THAT(chips.program, HasSubstr("Q2.5 "));
  const PlanResult pecks = plan_part(with_circle("DRILL_D10_PECK2.5", 4), with({"drill:4"}));
  expect_clean(pecks);
  EXPECT_THAT(pecks.program, HasSubstr("G98 G83 "));
}

TEST(HolePlan, ASpotDrillAmongTheToolsLeadsTheDrill) {
  const PlanResult result = plan_part(with_circle("DRILL_D8", 6), with({"drill:6", "spotdrill:90deg:10"}));
  expect_clean(result);
  EXPECT_THAT(result.program, HasSubstr("DRILL_D8_SPOT"));
  EXPECT_THAT(result.program, HasSubstr("Z-2.7 R1 "));
}

/// A cone wider than the counterbore, at whose floor the hole begins, goes down only until it would touch its wall.
TEST(HolePlan, SpotsAtTheFloorOfACounterboreKeepOffItsWall) {
  const PlanResult result =
      plan_part(drawn(box("STOCK_D12", -20, -20, 20, 20) + circle("DRILL_THRU", {0, 0}, 2.75) +
                      circle("CBORE_D4", {0, 0}, 5)),
                with({"endmill:6", "drill:5.5", "spotdrill:90deg:12"}));
  expect_clean(result);
  EXPECT_THAT(result.program, HasSubstr("Z-5 R-3 "));
}

TEST(HolePlan, CountersunkHolesAreSpottedBeforeTheyAreDrilled) {
  const PlanResult result =
      plan_part(drawn(box("STOCK_D12", -20, -20, 40, 40) + circle("DRILL_D8", {10, 10}, 3) +
                      circle("CSK_DIA9", {10, 10}, 4.5)),
                with({"drill:6", "spotdrill:90deg:10", "chamfer:90deg:12:tip=0.4"}));
  const auto spot = result.program.find("DRILL_D8_SPOT)"), drill = result.program.find("DRILL_D8)");
  ASSERT_NE(spot, std::string::npos) << result.program;
  EXPECT_LT(spot, drill);
}

TEST(HolePlan, ASpindleThatTurnsTooFastForATapIsSaid) {
  auto options = with({"drill:5", "tap:M6:floating"});
  options.machine.min_spindle_rpm = 8000;
  try {
    plan_part(with_circle("TAP_M6_D8", 6), options);
    FAIL() << "8 m/min are 424 rpm";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("taps at 424 rpm and the machine turns no slower than 8000"));
  }
}

TEST(HolePlan, AReamedHoleIsDrilledFirstAndLeftAtTheFeed) {
  const Part part = with_circle("REAM_DIA6_THRU", 5);
  const PlanResult result = plan_part(part, with({"drill:5.8", "reamer:6"}));
  expect_clean(result);
  EXPECT_THAT(result.program, HasSubstr("G98 G85 "));
  EXPECT_THAT(refusal(part, {"drill:5.8"}),
              HasSubstr("it needs a reamer of its width; give one, for example --tool reamer:6"));
  EXPECT_THAT(refusal(part, {"drill:5", "reamer:6"}), HasSubstr("before it comes a hole of 5.5 to 5.95 mm"));
}

TEST(HolePlan, BoringBarsAndMillsBore) {
  const Part part = with_circle("BORE_D8", 20);
  const PlanResult bar = plan_part(part, with({"endmill:12", "boringbar:20"}));
  expect_clean(bar);
  EXPECT_THAT(bar.program, HasSubstr("G98 G85 "));
  expect_clean(plan_part(part, with({"endmill:12"})));
}

TEST(HolePlan, CounterboresAreMilledOrMadeByTheirTool) {
  const std::string seat = circle("CBORE_D5", kCenter, 5.5), through = circle("DRILL_THRU", kCenter, 3.3);
  for (const char* tool : {"endmill:6", "counterbore:11"}) {
    const PlanResult result = plan_part(drawn(kBlock + seat + through), with({tool, "drill:6.6"}));
    expect_clean(result);
  }
}

TEST(HolePlan, ACountersinkHasItsDiameterAtTheTop) {
  const Part part = drawn(kBlock + circle("CSK_DIA9", kCenter, 4.5) + circle("DRILL_THRU", kCenter, 2.25));
  const auto options = with({"drill:4.5", "chamfer:90deg:10:tip=0.4"});
  const PlanResult result = plan_part(part, options);
  expect_clean(result);
  EXPECT_THAT(result.program, HasSubstr("Z-4.3 R1 "));
  const Findings deep = changed(part, result, "Z-4.3 R1", "Z-4.35 R1", options);
  EXPECT_TRUE(has(deep, FaultKind::kGouge)) << faults_of(deep);
  const Findings shallow = changed(part, result, "Z-4.3 R1", "Z-4.25 R1", options);
  EXPECT_TRUE(has(shallow, FaultKind::kUncut)) << faults_of(shallow);
  EXPECT_THAT(refusal(part, {"drill:4.5", "chamfer:90deg:8"}),
              HasSubstr("it needs a cone at least 9 mm wide"));
}

/// Coarse digits move the place and the depth of a cone: both together leave less than a gouge, also where the control may round corners.
TEST(HolePlan, CountersinksKeepOffTheirConeByTheDigitsOfTheControl) {
  for (const char* cone : {"chamfer:82deg:12:tip=0.4", "vbit:100deg:14", "spotdrill:120deg:16"}) {
    for (const char* control : {"haas", "fanuc", "siemens"}) {
      for (const bool inch : {false, true}) {
        std::string holes = kBlock;
        for (const Vec2 at : {Vec2{-8.00049, -7.31351}, Vec2{7.3145, 8.20449}})
          holes += circle("CSK_DIA9", at, 4.5) + circle("DRILL_THRU", at, 2.5);
        auto options = with({cone, "drill:5"});
        options.post.dialect = control;
        options.post.inch = inch;
        const PlanResult result = plan_part(drawn(holes), options);
        EXPECT_EQ(verdict_of(result.findings), Verdict::kClean)
            << cone << " " << control << (inch ? " inch " : " mm ") << faults_of(result.findings);
      }
    }
  }
}

/// A point that would come out below the material: the hole is milled, or left with all steps on its axis, and the rest is made.
TEST(HolePlan, WhatWouldComeOutBelowTheMaterialIsMilledOrLeft) {
  struct Row {
    const char* hole;
    double radius;
    std::vector<std::string> tools;
    std::size_t left;  ///< steps
  };
  const Row rows[] = {{"DRILL_D11.5", 3, {"drill:6:118deg", "endmill:5"}, 0},
                      {"DRILL_D11.5", 3, {"drill:6:118deg", "endmill:8"}, 1},
                      {"DRILL_D11.5", 3, {"drill:6:118deg", "endmill:8", "spotdrill:90deg:8"}, 1},
                      {"REAM_DIA6_D11.5", 3, {"drill:5.8", "reamer:6", "endmill:8"}, 2},
                      {"REAM_DIA6_D11.5", 3, {"drill:5.8", "reamer:6", "endmill:4"}, 0},
                      {"TAP_M6_D11", 3, {"drill:5", "tap:M6", "endmill:8"}, 2},
                      {"THREAD_M16_D11", 8, {"endmill:8", "threadmill:8"}, 2}};
  for (const Row& row : rows) {
    const Part part =
        drawn(kBlock + circle(row.hole, {-8, -8}, row.radius) + rounded_box("POCKET_D2", 2, 2, 18, 18, 5));
    const PlanResult result = plan_part(part, with(row.tools));
    const CheckResult checked = check_program(part, result.program, "hole.ngc", with(row.tools));
    for (const Findings* found : {&result.findings, &checked.findings}) {
      EXPECT_EQ(verdict_of(*found), row.left > 0 ? Verdict::kConditional : Verdict::kClean)
          << row.hole << " " << row.tools[1] << " " << faults_of(*found);
      EXPECT_EQ(open_conditions(*found).size(), row.left) << row.hole << " " << row.tools[1];
    }
  }
}

/// Floors a little below the material go through it; the point of a drill comes out of no blind hole, however little.
TEST(HolePlan, FloorsALittleBelowTheMaterialGoThrough) {
  struct Row {
    std::string entities;
    std::vector<std::string> tools;
    Verdict verdict;
  };
  const Row rows[] = {
      {rounded_box("POCKET_D12.3", 2, 2, 18, 18, 5), {"endmill:5"}, Verdict::kClean},
      {circle("DRILL_D12.3", kCenter, 3), {"endmill:5"}, Verdict::kClean},
      {circle("DRILL_D12.3", kCenter, 3), {"drill:6"}, Verdict::kClean},
      {circle("DRILL_D10.5", kCenter, 3), {"drill:6:118deg", "endmill:5"}, Verdict::kClean},
      {circle("TAP_M10_D5", kCenter, 4.25), {"drill:8.5", "tap:M10", "endmill:5"}, Verdict::kClean},
      {circle("TAP_M10_D5", kCenter, 4.25) + rounded_box("POCKET_D2", 10, 2, 28, 18, 5),
       {"drill:8.5", "tap:M10", "endmill:8"},
       Verdict::kConditional}};
  for (const Row& row : rows) {
    const Part part = drawn(kBlock + row.entities);
    const PlanResult result = plan_part(part, with(row.tools));
    const CheckResult checked = check_program(part, result.program, "x", with(row.tools));
    for (const Findings* found : {&result.findings, &checked.findings})
      EXPECT_EQ(verdict_of(*found), row.verdict) << &row - rows << " " << faults_of(*found);
  }
  EXPECT_THAT(plan_part(with_circle("DRILL_D12.3", 6), with({"drill:6"})).program, HasSubstr("Z-14.3026"));
  EXPECT_THAT(refusal(with_circle("DRILL_D12.6", 6), {"drill:6"}), HasSubstr("0.6 mm below the material"));
}

/// At its mouth a hole as deep as its drill's point is narrower by no more than may be left.
TEST(HolePlan, HolesAsDeepAsTheirDrillsPointAreDrilled) {
  const PlanResult result = plan_part(with_circle("DRILL_D1.5", 5.01), with({"drill:5.01", "endmill:8"}));
  EXPECT_EQ(faults_of(result.findings), "");
  EXPECT_THAT(result.program, HasSubstr("G98 G81"));
}

/// A flat end is taken before a rounded one; a rounded one alone clears down to its corner, with nothing in the middle.
TEST(HolePlan, CounterboresAreMilledByFlatAndRoundedEnds) {
  for (const char* other : {"endmill:5", "endmill:3", ""}) {
    for (const char* round : {"bullnose:5:corner=1", "bullnose:6:corner=1", "bullnose:8:corner=3"}) {
      std::vector<std::string> tools{round, "drill:5.5"};
      if (*other) tools.emplace_back(other);
      auto options = with(tools);
      options.accept = {"out-of-reach"};
      const Part part = with_circle("CBORE_D4", 10, circle("DRILL_THRU", kCenter, 2.75));
      const PlanResult result = plan_part(part, options);
      EXPECT_EQ(faults_of(result.findings), "") << round << " " << other;
      if (*other) {
        EXPECT_THAT(result.program, Not(HasSubstr("BULLNOSE"))) << round << " " << other;
      }
    }
  }
}

/// What facing leaves for its last pass stands over holes, which go through it; cones begin at the face, however deep it is, and
/// stock to leave on floors is for no hole that another tool comes into.
TEST(HolePlan, HolesUnderAFaceAreMadeWithAndWithoutStockOnIt) {
  const std::string holes = box("FACE_D2", -30, -30, 30, 30) + circle("REAM_D8", {0, 0}, 5) +
                            circle("CSK", {15, -15}, 4) + circle("DRILL_THRU", {15, -15}, 2.5) +
                            circle("SPOT", {-15, 0}, 2) + circle("BORE_D5", {0, 18}, 6) +
                            circle("THREAD_M16_D8", {-15, 18}, 8);
  const std::vector<std::string> tools{"endmill:5",    "drill:5",      "spotdrill:90deg:12",
                                       "drill:9.8",    "reamer:10",    "chamfer:90deg:12:tip=0.4",
                                       "vbit:90deg:8", "threadmill:8", "boringbar:12"};
  for (const char* finish : {"", "floor", "all"}) {
    for (const double left : {0.0, 0.5}) {
      auto options = with(tools);
      options.allowance_floor = left;
      if (*finish) options.shop.finish = finish;
      EXPECT_EQ(faults_of(plan_part(drawn(kBlock + holes), options).findings), "") << finish << " " << left;
    }
  }
}

/// Holes that a mill bores before another tool keep no stock for finishing.
TEST(HolePlan, HolesBeforeAnotherToolAreNotFinished) {
  auto options = with({"endmill:6", "boringbar:14", "threadmill:8"});
  options.shop.finish = "all";
  expect_clean(plan_part(drawn(kBlock + circle("BORE_D5", {-8, -8}, 7) + circle("THREAD_M16_D4", {9, 9}, 8)),
                         options));
}

TEST(HolePlan, SpotsAreMadeByConesThatCutWithTheirTips) {
  expect_clean(plan_part(with_circle("SPOT", 3), with({"chamfer:90deg:6:tip=0.4", "vbit:90deg:12"})));
}

TEST(HolePlan, TapsFeedTheirPitchAndComeBackTurningTheOtherWay) {
  const Part part = with_circle("TAP_M6_D7", 6);
  const auto options = with({"drill:5", "tap:M6:floating"});
  const PlanResult result = plan_part(part, options);
  expect_clean(result);
  EXPECT_THAT(result.program, HasSubstr("TAP D6 MM PITCH 1 FLOATING HOLDER"));
  EXPECT_THAT(result.program, HasSubstr("M3 S424"));
  EXPECT_THAT(result.program, HasSubstr("G98 G84 X5 Y-3 Z-9.5 R3 F424"));
  const auto faulty = [&](const std::string& what, const std::string& by, FaultKind kind) {
    const Findings found = changed(part, result, what, by, options);
    EXPECT_TRUE(has(found, kind)) << what << " -> " << by << "\n" << faults_of(found);
  };
  faulty("R3 F424", "R3 F500", FaultKind::kTapping);
  faulty("M3 S424", "M3 S500", FaultKind::kTapping);
  faulty("M3 S424", "M4 S424", FaultKind::kTapping);
  faulty("G98 G84", "G98 G85", FaultKind::kTapping);
  faulty("G98 G84", "G98 G81", FaultKind::kTapping);
  faulty("Z-9.5 R3", "Z-9 R3", FaultKind::kUncut);
  faulty("G98 G84 X5 Y-3 Z-9.5 R3 F424", "", FaultKind::kNothingCut);
}

/// Holes that one cycle makes are read back as those that have a cycle each, and certified by their own places.
TEST(HolePlan, HolesOfOneCycleAreReadBackOneByOne) {
  std::string holes = kBlock;
  for (const Vec2 at : {Vec2{-8, -8}, Vec2{8, -8}, Vec2{8, 8}, Vec2{-8, 8}})
    holes += circle("DRILL_D10", at, 1.5);
  const Part part = drawn(holes);
  for (const char* dialect : {"haas", "fanuc", "mazak", "tormach"}) {
    SCOPED_TRACE(dialect);
    auto options = with({"drill:3"});
    options.post.dialect = dialect;
    const PlanResult result = plan_part(part, options);
    expect_clean(result);
    EXPECT_EQ(result.program.find("G83"), result.program.rfind("G83")) << result.program;
    EXPECT_EQ(result.findings.features.size(), 4U);
    const std::string moved = std::string(dialect) == "tormach" ? "X-8 Y8" : "X-8. Y8.";
    const std::string by = std::string(dialect) == "tormach" ? "X-7.9 Y8" : "X-7.9 Y8.";
    if (result.program.find("\n" + moved) == std::string::npos) continue;  // the cycle's own block
    const Findings wrong =
        changed(part, result, "\n" + moved, "\n" + by, options, *read::gcode::dialect_named(dialect));
    EXPECT_TRUE(has(wrong, FaultKind::kUncut) || has(wrong, FaultKind::kGouge)) << faults_of(wrong);
  }
}

/// Whatever the material: what is deeper than three diameters is pecked.
TEST(HolePlan, DeepHolesArePeckedInWoodAndPlastics) {
  for (const char* material : {"softwood", "plywood", "mdf", "plastic"}) {
    auto options = with({"drill:3"});
    options.shop.material = material;
    const PlanResult deep = plan_part(drawn(kBlock + circle("DRILL_D10", {0, 0}, 1.5)), options);
    EXPECT_THAT(deep.program, HasSubstr("G98 G83 ")) << material;
    const PlanResult shallow = plan_part(drawn(kBlock + circle("DRILL_D6", {0, 0}, 1.5)), options);
    EXPECT_THAT(shallow.program, HasSubstr("G98 G81 ")) << material;
  }
}

TEST(HolePlan, LeftHandTapsTurnTheOtherWay) {
  const PlanResult result = plan_part(with_circle("TAP_M6_LH_D7", 6), with({"drill:5", "tap:M6LH:floating"}));
  expect_clean(result);
  EXPECT_THAT(result.program, HasSubstr("M4 S424"));
  EXPECT_THAT(result.program, HasSubstr("G98 G74 "));
}

TEST(HolePlan, EachControlTapsInItsWordsOrSaysWhyNot) {
  const Part part = with_circle("TAP_M6_D7", 6);
  for (const std::string& dialect : post::post_dialects()) {
    SCOPED_TRACE(dialect);
    auto options = with({"drill:5", "tap:M6:floating"});
    options.post.dialect = dialect;
    if (dialect == "marlin") options.accept = {"tool-by-hand"};
    expect_clean(plan_part(part, options));
    options.tools[1].floating = false;
    const std::map<std::string, std::string> rigid{{"linuxcnc", "G33.1 Z-9.5 K1"},
                                                   {"fanuc", "M29 S424\nG98 G84 "},
                                                   {"haas", "G98 G84 "},
                                                   {"siemens", "MCALL CYCLE84("},
                                                   {"heidenhain", "CYCL DEF 207 RIGID TAPPING NEW ~\n"}};
    if (rigid.count(dialect)) {
      const PlanResult result = plan_part(part, options);
      expect_clean(result);
      EXPECT_THAT(result.program, HasSubstr(rigid.at(dialect)));
    } else {
      EXPECT_THROW(plan_part(part, options), InputError);
    }
  }
}

/// The cycle's depth, pitch, hand and place are what is checked, wherever its words stand.
TEST(HolePlan, RigidTapsOfHeidenhainAreCheckedByTheirPitch) {
  const Part part = with_circle("TAP_M6_D7", 6);
  auto options = with({"drill:5", "tap:M6"});
  options.post.dialect = "heidenhain";
  const PlanResult result = plan_part(part, options);
  expect_clean(result);
  const auto faulty = [&](const std::string& what, const std::string& by, FaultKind kind) {
    const Findings found = changed(part, result, what, by, options, Dialect::kHeidenhain);
    EXPECT_TRUE(has(found, kind)) << what << " -> " << by << "\n" << faults_of(found);
  };
  faulty("Q239=+1 ", "Q239=+1.25 ", FaultKind::kTapping);
  faulty("Q239=+1 ", "Q239=-1 ", FaultKind::kTapping);
  faulty("207 RIGID TAPPING NEW ~\n  Q200=+3 ;SET-UP CLEARANCE ~\n  Q201=-9.5 ",
         "207 RIGID TAPPING NEW ~\n  Q200=+3 ;SET-UP CLEARANCE ~\n  Q201=-9 ", FaultKind::kUncut);
  // The pitch of M4 x 0.7 is no four digits of an inch.
  options = with({"drill:3.3", "tap:M4"});
  options.post.dialect = "heidenhain";
  const Part small = with_circle("TAP_M4_D5", 4);
  expect_clean(plan_part(small, options));
  options.post.inch = true;
  EXPECT_THROW(plan_part(small, options), InputError);
}

TEST(HolePlan, TapsAskForTheirDrill) {
  EXPECT_THAT(
      refusal(with_circle("TAP_M6_D7", 6), {"drill:5.5", "tap:M6"}),
      HasSubstr(
          "before it comes a hole of 4.917 to 5.147 mm; give a drill for it, for example --tool drill:5,"));
  EXPECT_THAT(refusal(with_circle("TAP_M8_D7", 6), {"drill:6.8", "tap:M6"}),
              HasSubstr("it is to be tapped M8; give the tap, for example --tool tap:M8"));
  EXPECT_THROW(with_circle("TAP_D7", 6), InputError);
  EXPECT_THROW(with_circle("TAP_M6.3_D7", 6), InputError);
}

TEST(HolePlan, ThreadsAreMilledAlongTheirHelix) {
  const Part part = with_circle("THREAD_M20x1.5_THRU", 20);
  const auto options = with({"endmill:10", "threadmill:12"});
  const PlanResult result = plan_part(part, options);
  expect_clean(result);
  EXPECT_THAT(refusal(part, {"endmill:10"}), HasSubstr("its thread M20X1.5 is to be milled"));
}

TEST(HolePlan, ThreadsAreCheckedWhereChordsStandForArcs) {
  const Part part = with_circle("THREAD_M20x1.5_D8", 20);
  auto options = with({"endmill:10", "threadmill:12"});
  options.post.arcs = false;
  const PlanResult result = plan_part(part, options);
  expect_clean(result);
  Toolpath steep = result.toolpath;
  for (Section& section : steep.sections) {
    if (section.tool_number != 2) continue;
    for (Move& move : section.moves) {
      if (move.kind == MoveKind::kRapid) continue;
      for (double* z : {&move.z_from, &move.z_to}) *z = *z < 0 ? *z * 1.05 : *z;
    }
  }
  const std::string program = post::write_program(steep, result.part, options.post);
  const auto found = check_program(part, program, "steep", options, Dialect::kLinuxCnc).findings;
  EXPECT_TRUE(has(found, FaultKind::kThread)) << "pitch of 1.575";
}

/// Dense places of a program against the surface of the thread, without the verifier's formulas: how far the mill cuts beside it.
double worst_beside(const PlanResult& result, const Thread& thread, double z_top, int mill) {
  std::vector<std::array<double, 3>> full;  // angle, z, reach of whole turns
  double worst = 0;
  std::optional<double> phase;
  for (const Section& section : result.toolpath.sections) {
    if (section.tool_number != mill) continue;
    for (const Move& move : section.moves) {
      if (is_rapid(move.kind) || move.is_vertical()) continue;
      for (int i = 0; i <= 100; ++i) {
        const Vec2 p = move.path.at(i / 100.0) - kCenter;
        const double z = move.z_from + (move.z_to - move.z_from) * i / 100.0;
        const double reach = norm(p) + result.part.tools[static_cast<std::size_t>(mill) - 1].radius();
        if (z > z_top || reach < minor_diameter(thread) / 2 + 0.3) continue;
        double turns = z / thread.pitch - (thread.left_hand ? -1 : 1) * std::atan2(p.y, p.x) / (2 * kPi);
        turns -= std::floor(turns);
        if (!phase) phase = turns;
        const double off = std::abs(turns - *phase);
        worst = std::max(worst, std::min(off, 1 - off) * thread.pitch);
        EXPECT_LE(reach, thread.diameter / 2 + 0.001);
      }
    }
  }
  EXPECT_TRUE(phase.has_value());
  return worst;
}

TEST(HolePlan, ManyThreadsLieOnTheirHelix) {
  Random random(31);
  const char* const kNames[] = {"M8", "M10x1", "M12", "M16x1.5", "M20", "UNC1-2", "UNF3-8", "M24x2"};
  for (int i = 0; i < 60; ++i) {
    Thread thread = *thread_named(kNames[random.below(8)]);
    const bool left = random.below(2) == 1, rows = random.below(2) == 1;
    thread = *thread_named(thread.name + (left ? "LH" : ""));
    const double depth = random.between(4, 9);
    const std::string layer =
        fmt::format("THREAD_{}{}_D{:.2f}", thread.name.substr(0, thread.name.size() - (left ? 2 : 0)),
                    left ? "_LH" : "", depth);
    SCOPED_TRACE(layer);
    const std::string mill =
        fmt::format("threadmill:{:.2f}{}", minor_diameter(thread) * random.between(0.5, 0.8),
                    rows ? fmt::format(":pitch={}:length={}", thread.pitch, 4 * thread.pitch) : "");
    auto options = with({fmt::format("endmill:{:.2f}", minor_diameter(thread) * 0.6), mill});
    if (random.below(2) == 1) options.direction = CutDirection::kConventional;
    const std::string stock = box("STOCK_D40", -30, -30, 30, 30);
    const PlanResult result = plan_part(drawn(stock + circle(layer, kCenter, thread.diameter / 2)), options);
    expect_clean(result);
    EXPECT_LT(worst_beside(result, thread, 0, 2), 0.003);
  }
}

TEST(HolePlan, WrongThreadsAreFound) {
  const Part part = with_circle("THREAD_M20x1.5_D8", 20);
  const auto options = with({"endmill:10", "threadmill:12"});
  const PlanResult result = plan_part(part, options);
  Toolpath path = result.toolpath;
  const auto verdict = [&](const auto& change) {
    Toolpath wrong = result.toolpath;
    for (Section& section : wrong.sections) {
      if (section.tool_number == 2) change(section);
    }
    PostOptions post = options.post;
    const std::string program = post::write_program(wrong, result.part, post);
    return check_program(part, program, "wrong", options, Dialect::kLinuxCnc).findings;
  };
  const auto stretch = [](double by) {
    return [by](Section& section) {
      for (Move& move : section.moves) {
        if (is_rapid(move.kind)) continue;
        if (move.z_from < 0) move.z_from *= by;
        if (move.z_to < 0) move.z_to *= by;
      }
    };
  };
  EXPECT_TRUE(has(verdict(stretch(0.9)), FaultKind::kThread)) << "pitch of 1.35";
  const auto narrower = [](Section& section) {
    for (Move& move : section.moves) {
      for (Vec2* p : {&move.path.from, &move.path.to, &move.path.center})
        *p = kCenter + (*p - kCenter) * 0.98;
    }
  };
  EXPECT_TRUE(has(verdict(narrower), FaultKind::kUncut));
  const auto wider = [](Section& section) {
    for (Move& move : section.moves) {
      for (Vec2* p : {&move.path.from, &move.path.to, &move.path.center})
        *p = kCenter + (*p - kCenter) * 1.01;
    }
  };
  EXPECT_TRUE(has(verdict(wider), FaultKind::kGouge));
  const auto missing = [](Section& section) { section.moves.resize(1); };
  EXPECT_TRUE(has(verdict(missing), FaultKind::kNothingCut));
  const auto mirrored = [](Section& section) {
    for (Move& move : section.moves) {
      for (Vec2* p : {&move.path.from, &move.path.to, &move.path.center}) p->y = 2 * kCenter.y - p->y;
      if (move.path.is_arc())
        move.path.turn = move.path.turn == Turn::kClockwise ? Turn::kCounterClockwise : Turn::kClockwise;
    }
  };
  EXPECT_TRUE(has(verdict(mirrored), FaultKind::kThread)) << "left hand";
}

TEST(HolePlan, WhatOneToolOfAJobStatesDoesNotBindTheOthers) {
  // As of a job: the drawing's step is read with the end mill, whose stepdown and plunge feed it then holds.
  Part part = with_circle("TAP_M6_THRU", 6);
  part.tools = {resolve::parse_tool("endmill:4"), resolve::parse_tool("drill:5"),
                resolve::parse_tool("tap:M6:floating")};
  for (std::size_t i = 0; i < part.tools.size(); ++i) part.tools[i].number = static_cast<int>(i) + 1;
  PlanOptions options;
  options.tool_cutting.resize(3);
  ToolCutting& mill = options.tool_cutting.front();
  mill.stated = true;
  mill.stepdown = 1;
  mill.cutting.plunge_feed = MmPerMin::of(50);
  for (Workingstep& step : part.workplan) {
    step.operation.tool = 0;
    step.operation.stepdown = mill.stepdown;
    step.operation.cutting = mill.cutting;
  }
  const PlanResult planned = plan_part(part, options);
  expect_clean(planned);
  const Findings checked =
      check_program(part, planned.program, "again", options, Dialect::kLinuxCnc).findings;
  EXPECT_TRUE(checked.all.clean) << faults_of(checked);
}

TEST(Threads, HaveTheSizesOfTheirTables) {
  EXPECT_EQ(thread_named("M6")->pitch, 1);
  EXPECT_EQ(thread_named("m20x1.5")->pitch, 1.5);
  EXPECT_NEAR(thread_named("1/4-20")->pitch, 1.27, 1e-12);
  EXPECT_NEAR(thread_named("UNC1-4")->diameter, 6.35, 1e-12);
  EXPECT_NEAR(thread_named("UNF#10")->pitch, 25.4 / 32, 1e-12);
  EXPECT_NEAR(thread_named("#10-24")->diameter, 4.826, 1e-12);
  EXPECT_TRUE(thread_named("M8LH")->left_hand);
  for (const char* wrong : {"", "M", "M6.1", "M6x", "M6x5", "UNC", "UNC9", "1/4", "1/4-", "6", "X"})
    EXPECT_FALSE(thread_named(wrong)) << wrong;
  EXPECT_NEAR(minor_diameter(*thread_named("M6")), 4.917, 0.001);
  EXPECT_NEAR(minor_diameter(*thread_named("M20")), 17.294, 0.001);
  EXPECT_NEAR(minor_tolerance(*thread_named("M3")), 0.14, 0.01);
  EXPECT_NEAR(minor_tolerance(*thread_named("M20")), 0.45, 0.02);
}

TEST(Threads, ToolsSayTheirs) {
  const Tool tap = resolve::parse_tool("tap:M6x0.75:floating");
  EXPECT_EQ(tap.diameter, 6);
  EXPECT_EQ(tap.pitch, 0.75);
  EXPECT_TRUE(tap.floating);
  EXPECT_EQ(resolve::parse_tool("tap:6:pitch=1:left").left_hand, true);
  for (const char* wrong :
       {"tap:6", "endmill:6:pitch=1", "drill:5:floating", "threadmill:10:pitch=1", "tap:M6:pitch=9"})
    EXPECT_THROW(resolve::parse_tool(wrong), InputError) << wrong;
}

}  // namespace
}  // namespace clearcut::pipeline
