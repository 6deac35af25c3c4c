// Plans within what is stated: limits of the engagement, of the machine, of the digits of its control; and refusals where nothing is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;

std::string refused(const Part& part, const PlanOptions& options) {
  try {
    return std::string("not refused: ") + name_of(verdict_of(plan_part(part, options).findings));
  } catch (const InputError& error) {
    return error.what();
  }
}

PlanOptions under_limit(const std::string& tool, const std::string& strategy, double degrees) {
  PlanOptions options = with({tool});
  options.strategy = strategy;
  options.engagement_deg = degrees;
  return options;
}

TEST(StatedLimits, AStrategyThatCannotHoldTheEngagementIsRefused) {
  const Part pocket = drawn(box("POCKET_D2", 0, 0, 24, 18));
  for (const char* strategy : {"contour", "zigzag", "spiral"}) {
    const std::string said = refused(pocket, under_limit("endmill:6", strategy, 90));
    EXPECT_THAT(said, HasSubstr("--engagement: POCKET_D2 would engage the cutter by 180 degrees where 90"));
    EXPECT_THAT(said, HasSubstr(std::string("the strategy ") + strategy));
    EXPECT_THAT(said, HasSubstr("use adaptive"));
  }
  EXPECT_THAT(refused(pocket, under_limit("endmill:6", "adaptive", 90)), HasSubstr("not refused"));
  EXPECT_THAT(refused(pocket, under_limit("endmill:6", "contour", 180)), HasSubstr("not refused"));
}

TEST(StatedLimits, AProfileIsCutAtFullWidthAndRefusedUnderALimit) {
  const Part part = drawn(box("PROFILE_D2", 0, 0, 24, 18));
  EXPECT_THAT(
      refused(part, under_limit("endmill:6", "auto", 90)),
      HasSubstr("a cut along an outline has the full width of the cutter; plan it in a program of its own"));
}

/// Whatever the strategy: a slot as wide as the cutter, and a thread, which is milled to its full depth at once.
TEST(StatedLimits, PlacesWithoutRoomToHoldTheEngagementAreRefused) {
  for (const char* strategy : {"auto", "adaptive"}) {
    EXPECT_THAT(
        refused(drawn(box("POCKET_D2", 0, 0, 6, 18)), under_limit("endmill:6", strategy, 90)),
        HasSubstr("POCKET_D2 would engage the cutter by 180 degrees where 90 are the limit: T1 (6 mm) has no "
                  "room there to hold it; take a narrower cutter"));
  }
  PlanOptions options = with({"endmill:6", "threadmill:10"});
  options.engagement_deg = 60;
  EXPECT_THAT(refused(drawn(circle("THREAD_M16_D6", {0, 0}, 8)), options),
              HasSubstr("a thread is milled to its full"));
}

/// Faces of which the cutter may leave the stock on all sides; rounded corners meet their edges with the whole radius.
TEST(StatedLimits, FacesAreClearedWithinTheEngagement) {
  const std::string face = box("STOCK_D10", 0, 0, 33.6, 29.3) + box("FACE_D0.8", 0, 0, 33.6, 29.3);
  for (const char* const tool : {"endmill:3", "endmill:6", "bullnose:6:corner=0.5"}) {
    for (const double limit : {60.0, 75.0, 100.0, 120.0}) {
      SCOPED_TRACE(testing::Message() << tool << " " << limit);
      const PlanResult plan = plan_part(drawn(face), under_limit(tool, "adaptive", limit));
      EXPECT_TRUE(plan.findings.faults.empty()) << faults_of(plan.findings);
    }
  }
}

TEST(StatedLimits, SpindleSpeedsBeyondTheMachineAreRefused) {
  const Part part = drawn(box("POCKET_D2", 0, 0, 24, 18));
  PlanOptions options = with({"endmill:6"});
  options.machine.max_spindle_rpm = 6000;
  options.cutting.spindle_rpm = 9000;
  EXPECT_THAT(refused(part, options),
              HasSubstr("a spindle speed of 9000 with T1 where the machine has no more than 6000"));
  options.cutting.spindle_rpm = 6000;
  EXPECT_THAT(refused(part, options), HasSubstr("not refused"));
}

TEST(StatedLimits, AFeatureNoDeeperThanTheStockToLeaveIsRefused) {
  const Part part = drawn(box("POCKET_D0.3", 0, 0, 24, 18));
  PlanOptions options = with({"endmill:6"});
  options.allowance_floor = 0.3;
  EXPECT_THAT(refused(part, options),
              HasSubstr("POCKET_D0.3: it is 0.3 mm deep and 0.3 mm are to be left on its floor"));
  options.allowance_floor = 0.1;
  EXPECT_THAT(refused(part, options), HasSubstr("not refused"));
}

/// The hole lies within the box of the profile, whose kerf is far from it.
TEST(StatedLimits, AHoleWithinAProfileIsNoWayInForAMillThatMayNotPlunge) {
  const Part part = drawn(box("PROFILE_D2", 0, 0, 40, 30) + circle("DRILL_D2", {20, 15}, 2));
  EXPECT_THAT(refused(part, with({"endmill:4:noplunge"})), HasSubstr("may not plunge and has no room"));
}

/// Two walls that meet at a small angle: stock kept for the digits of inches on both of them is a wide strip at the end.
TEST(StatedLimits, StockForCoarseDigitsLeavesNothingUncutWherePlacesNarrowDown) {
  const char* const text =
      R"({"units": "mm", "pockets": [{"name": "A", "top": 0, "depth": 1.51, "outer": [[0, 6.83, 1], [13.66, 6.83, 1]],
      "islands": [[[4.098, 2.604], [6.147, 2.604], [6.147, 5.208], [4.098, 5.208]]]}]})";
  PlanOptions options = with({"bullnose:4:corner=0.5"});
  options.strategy = "contour";
  options.post.dialect = "haas";
  options.post.inch = true;
  options.accept = {"out-of-reach"};
  const PlanResult plan = plan_part(read::read_part_text(text, "part.json", {}), options);
  EXPECT_TRUE(plan.findings.faults.empty()) << faults_of(plan.findings);
}

/// Flanks that keep the leaning walls of A would cut into the upright ones of B.
TEST(StatedLimits, ATaperedMillIsNotChosenWhereSteeperWallsMeetLeaningOnes) {
  const char* const text =
      R"({"units": "mm", "pockets": [
      {"name": "A", "top": 0, "depth": 1.5, "slope_rad": 0.18, "outer": [[0, 0], [18.87, 0], [18.87, 6.5], [0, 6.5]]},
      {"name": "B", "top": 0, "depth": 2.4, "outer": [[16.87, 0], [25.5, 0], [25.5, 17.8], [16.87, 17.8]]}]})";
  PlanOptions options = with({"endmill:1.5", "tapered:2:taper=5deg:length=12"});
  options.strategy = "contour";
  options.accept = {"out-of-reach"};
  const PlanResult plan = plan_part(read::read_part_text(text, "part.json", {}), options);
  EXPECT_TRUE(plan.findings.faults.empty()) << faults_of(plan.findings);
}

/// The leaning wall of L stands nowhere in U, which cuts it away: no stock to leave on a floor is met there.
TEST(StatedLimits, StockToLeaveOnAFloorIsNotMetByAWallThatAnotherPocketCutsAway) {
  const char* const text =
      R"({"units": "mm", "pockets": [
      {"name": "L", "top": 0, "depth": 3, "slope_rad": 0.035, "outer": [[0, 0], [18, 0], [18, 12], [0, 12]]},
      {"name": "U", "top": 0, "depth": 3.4, "outer": [[16, 0], [29, 0], [29, 15], [16, 15]]},
      {"name": "C", "top": 0, "depth": 2, "outer": [[40, 0], [54, 0], [54, 14], [40, 14]]}]})";
  PlanOptions options = with({"endmill:4"});
  options.strategy = "contour";
  options.allowance_floor = 0.3;
  options.accept = {"out-of-reach"};
  const PlanResult plan = plan_part(read::read_part_text(text, "part.json", {}), options);
  EXPECT_FALSE(has(plan.findings, FaultKind::kStockToLeave)) << faults_of(plan.findings);
}

/// The tip of the cone runs beside the block, whose edge its flank breaks.
TEST(StatedLimits, AConeThatCutsWithItsFlankAloneCutsSomething) {
  const std::string program =
      "G21 G90 G17 G40 G49 G54 G80 G94 G64 P0.001\nT1 M6\nG43 H1\nM3 S9000\nG0 X-2 Y-8\nG0 Z5\nG1 Z-3 "
      "F300\nG1 "
      "Y38\nG0 Z5\nM5\nM2\n";
  const Stock stock{{{0, 0}, {30, 30}}, -10, 0};
  const auto open = [&](const std::string& text) {
    const CheckResult result =
        check_program_alone(stock, text, "flank.ngc", with({"chamfer:10:90deg:tip=1"}));
    return std::any_of(result.findings.conditions.begin(), result.findings.conditions.end(),
                       [](const Condition& one) { return one.name == "cuts-nothing"; });
  };
  EXPECT_FALSE(open(program));
  std::string beside = program;
  beside.replace(beside.find("X-2"), 3, "X-9");
  EXPECT_TRUE(open(beside));
}

/// Controls with a word for it round corners by as much as leaves the part clean, which is told where it is less than asked;
/// the path stays the same.
TEST(StatedLimits, CornersAreRoundedByAsMuchAsIsProven) {
  const Part pocket = drawn(box("POCKET_D2", 0, 0, 40, 28));
  struct Row {
    const char* post;
    const char* usual;
    const char* asked;
  };
  const Row rows[] = {{"linuxcnc", "G64 P0.0005 Q0", "G64 P0.004 Q0"},
                      {"haas", "G187 P2 E0.0005", "G187 P2 E0.004"},
                      {"siemens", "G642 CTOL=0.0005", "G642 CTOL=0.004"},
                      {"heidenhain", "CYCL DEF 32.1 T0.0005", "CYCL DEF 32.1 T0.004"}};
  for (const Row& row : rows) {
    SCOPED_TRACE(row.post);
    PlanOptions options = with({"endmill:6"});
    options.strategy = "zigzag";
    options.cutting.feed = MmPerMin::of(3000);
    options.post.dialect = row.post;
    const PlanResult usual = plan_part(pocket, options);
    options.post.corner_tolerance = 0.004;
    const PlanResult rounded = plan_part(pocket, options);
    EXPECT_THAT(usual.program, HasSubstr(row.usual));
    EXPECT_THAT(rounded.program, HasSubstr(row.asked));
    EXPECT_EQ(verdict_of(rounded.findings), Verdict::kClean) << faults_of(rounded.findings);
    EXPECT_EQ(rounded.findings.all.feed_mm, usual.findings.all.feed_mm);
    EXPECT_LT(rounded.findings.all.time_s, usual.findings.all.time_s);
    options.post.corner_tolerance = 0.5;
    const PlanResult narrowed = plan_part(pocket, options);
    EXPECT_EQ(verdict_of(narrowed.findings), Verdict::kClean) << faults_of(narrowed.findings);
    EXPECT_LE(narrowed.findings.all.path_tolerance_mm, 0.01);
    EXPECT_LT(narrowed.findings.all.time_s, usual.findings.all.time_s);
    EXPECT_THAT(
        narrowed.part.diagnostics.items(),
        Contains(Field(&Diagnostic::what, HasSubstr("the control may round corners by less than 0.5 mm"))));
  }
}

/// At 60 mm/min no corner is slowed down for, so that rounding it by more saves nothing: the refusal says so.
TEST(StatedLimits, ARoundingThatSavesNothingIsRefusedWithTheReason) {
  PlanOptions options = with({"endmill:6"});
  options.strategy = "contour";
  options.cutting.feed = MmPerMin::of(60);
  options.post.dialect = "linuxcnc";
  options.post.corner_tolerance = 0.004;
  options.sources.set("corner-tolerance", {Origin::kUser, "--corner-tolerance"});
  EXPECT_THAT(
      [&] { plan_part(drawn(box("POCKET_D2", 0, 0, 40, 20)), options); },
      ThrowsMessage<InputError>(HasSubstr("rounding its corners by more saves no time or leaves too much")));
}

}  // namespace
}  // namespace clearcut::pipeline
