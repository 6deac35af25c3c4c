// What no cutter at hand reaches: said, with the cutter that would, and open in the verdict where it is much.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "geometry/region.h"
#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

PlanOptions by_contour(const std::string& tool) {
  PlanOptions options = with({tool});
  options.strategy = "contour";
  return options;
}

TEST(OutOfReach, IsSaidWithTheLargestCutterThatReaches) {
  const Part part = drawn(box("POCKET_D2", 0, 0, 40, 30) + box("POCKET_D2", 50, 0, 90, 30));
  const auto result = plan_part(part, by_contour("endmill:10"));
  ASSERT_EQ(result.findings.conditions.size(), 2u);
  EXPECT_THAT(result.program, HasSubstr("(CONDITIONS: 2 X OUT-OF-REACH AT MOST 2 PERCENT OR 1 MM2)"));
  EXPECT_EQ(result.findings.conditions[0].name, "out-of-reach");
  EXPECT_THAT(result.findings.conditions[0].text, HasSubstr("out of the reach of T1 (10 mm)"));
  EXPECT_THAT(result.findings.conditions[0].text,
              HasSubstr("the largest cutter that reaches all but 1 mm2 has 2.1"));
}

/// What the flutes do not reach is left out, on sheets of copies as alone; plan and check say the same of it.
TEST(OutOfReach, IsAPocketDeeperThanTheFlutesBesideWorkThatIsDone) {
  const Part part = drawn(box("POCKET_D2", 0, 0, 20, 10) + box("POCKET_D70", 30, 0, 50, 10));
  for (const bool on_sheet : {false, true}) {
    PlanOptions options = by_contour("endmill:5");
    if (on_sheet) {
      options.copies.sheet = "120x40";
      options.copies.gap = 8;
      options.copies.edge = 5;
    }
    const PlanResult result = plan_part(part, options);
    const CheckResult checked = check_program(part, result.program, "x", options);
    for (const Findings* findings : {&result.findings, &checked.findings}) {
      EXPECT_EQ(verdict_of(*findings), Verdict::kConditional) << faults_of(*findings);
      const auto& all = findings->conditions;
      EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const Condition& one) {
        return one.name == "out-of-reach" && one.met_by.empty() &&
               one.text.find("POCKET_D70") != std::string::npos &&
               one.text.find("70 mm deep, 14 diameters of T1") != std::string::npos;
      }));
    }
    options.accept = {"out-of-reach"};
    EXPECT_EQ(verdict_of(plan_part(part, options).findings), Verdict::kClean);
  }
}

/// The program up to the last change of its tool, and its end.
std::string without_last_tool(const std::string& program) {
  const std::size_t change = program.rfind("(TOOL CHANGE"), end = program.rfind("M5\n");
  return program.substr(0, change) + program.substr(end);
}

/// What is accepted as out of reach is what no given tool reaches as a plan would use it.
TEST(OutOfReach, AcceptedIsNotWhatAGivenToolWouldReach) {
  const Part part = drawn(box("POCKET_D2", 0, 0, 30, 24));
  auto options = with({"endmill:12", "endmill:3"});
  options.shop.rest = true;
  options.accept = {"out-of-reach"};
  const PlanResult planned = plan_part(part, options);
  EXPECT_EQ(verdict_of(planned.findings), Verdict::kClean) << faults_of(planned.findings);
  EXPECT_EQ(verdict_of(check_program(part, planned.program, "whole.ngc", options).findings), Verdict::kClean);
  const std::string wider = without_last_tool(planned.program);
  EXPECT_TRUE(has(check_program(part, wider, "wider.ngc", options).findings, FaultKind::kUncut));
  options.tools.pop_back();
  options.shop.rest.reset();
  EXPECT_EQ(verdict_of(check_program(part, wider, "wider.ngc", options).findings), Verdict::kClean);
}

/// A hole in the floor of a pocket, deeper than its drill, is left out; drilled as deep as the drill goes it is faulty.
TEST(OutOfReach, IsAHoleUnderAPocketDeeperThanItsDrill) {
  const Part part = drawn(box("STOCK_D30", -9, -9, 39, 29) + box("POCKET_D5", 0, 0, 30, 20) +
                          circle("DRILL_D20", {15, 10}, 2));
  const PlanOptions options = with({"endmill:6", "drill:4:length=12"});
  const PlanResult result = plan_part(part, options);
  const CheckResult checked = check_program(part, result.program, "x", options);
  for (const Findings* findings : {&result.findings, &checked.findings}) {
    EXPECT_EQ(verdict_of(*findings), Verdict::kConditional) << faults_of(*findings);
    const std::string said = texts_of(*findings);
    EXPECT_THAT(said, HasSubstr("DRILL_D20: its floor lies"));
  }
  std::string half = result.program;
  half.replace(half.find("\nM2"), 3, "\nG0 Z5\nT2 M6\nG43\nM3 S1000\nG0 X15 Y10\nG1 Z-11 F100\nG0 Z5\nM2");
  EXPECT_EQ(verdict_of(check_program(part, half, "x", options).findings), Verdict::kFaulty);
}

/// A narrower mill that is too short for the corners which it is asked to mill does not take the pocket away.
TEST(OutOfReach, IsARestBeyondTheFlutesOfItsMill) {
  const Part part = drawn(box("POCKET_D40", 0, 0, 40, 30));
  PlanOptions options = with({"endmill:6", "endmill:3"});
  options.strategy = "contour";
  options.shop.rest = true;
  const PlanResult result = plan_part(part, options);
  const CheckResult checked = check_program(part, result.program, "x", options);
  for (const Findings* findings : {&result.findings, &checked.findings}) {
    EXPECT_EQ(verdict_of(*findings), Verdict::kConditional) << faults_of(*findings);
    const std::string said = texts_of(*findings);
    EXPECT_THAT(said,
                HasSubstr("T2 does not mill what the wider tools leave: it is 40 mm deep, 13 diameters"));
    EXPECT_THAT(said, ::testing::Not(HasSubstr("with --rest T2")));
  }
}

/// Where no cutter fits into a pocket there is no edge to break.
TEST(OutOfReach, IsTheChamferOfAPocketThatIsNotMade) {
  const Part part = drawn(box("POCKET_D2", 0, 0, 20, 10) + box("POCKET_D2", 30, 0, 50, 2.5) +
                          box("CHAMFER_D0.4", 30, 0, 50, 2.5));
  const PlanOptions options = with({"endmill:3", "chamfer:90deg:8"});
  const PlanResult result = plan_part(part, options);
  const CheckResult checked = check_program(part, result.program, "x", options);
  for (const Findings* findings : {&result.findings, &checked.findings}) {
    EXPECT_EQ(verdict_of(*findings), Verdict::kConditional) << faults_of(*findings);
    const std::string said = texts_of(*findings);
    EXPECT_THAT(said,
                HasSubstr("CHAMFER_D0.4: it has no edge to break, as nothing reaches into POCKET_D2_2"));
  }
}

TEST(OutOfReach, IsAConditionOfTheVerdictWhereItIsMuch) {
  // A slot of 2 mm beside a square: most of it is too narrow for the cutter.
  const Part part = drawn(outline(
      "POCKET_D2", {{{0, 0}}, {{10, 0}}, {{10, 4}}, {{40, 4}}, {{40, 6}}, {{10, 6}}, {{10, 10}}, {{0, 10}}}));
  PlanOptions options = by_contour("endmill:4");
  const auto result = plan_part(part, options);
  EXPECT_EQ(verdict_of(result.findings), Verdict::kConditional);
  EXPECT_THAT(result.program, HasSubstr("CONDITIONS: OUT-OF-REACH"));
  options.accept = {"out-of-reach"};
  EXPECT_EQ(verdict_of(plan_part(part, options).findings), Verdict::kClean);
  const Part square = drawn(box("POCKET_D2", 0, 0, 60, 40));
  EXPECT_EQ(verdict_of(plan_part(square, by_contour("endmill:10")).findings), Verdict::kClean);
}

/// Tabs change nothing about the corners of a profile.
TEST(OutOfReach, IsTheSameOfProfilesWithTabsAndWithout) {
  const auto conditions = [](const std::string& layer, const std::string& tool, int tabs, TabShape shape) {
    PlanOptions options = by_contour(tool);
    options.tabs.count = tabs;
    options.tabs.shape = shape;
    const auto result = plan_part(drawn(box(layer, 0, 0, 60, 40)), options);
    std::string text = std::string(name_of(verdict_of(result.findings))) + "\n";
    for (const Condition& one : result.findings.conditions) text += one.text + " " + one.met_by + "\n";
    return text;
  };
  for (const char* tool : {"endmill:3", "endmill:6", "endmill:12"}) {
    const std::string without = conditions("INSIDE_D4", tool, 0, TabShape::kSquare);
    EXPECT_THAT(without, HasSubstr("CLEAN"));
    EXPECT_EQ(conditions("INSIDE_D4", tool, 2, TabShape::kSquare), without);
    EXPECT_EQ(conditions("INSIDE_D4", tool, 2, TabShape::kTriangular), without);
  }
}

/// A frame with rounded corners outside and sharp ones inside, as a pen of that width draws it about a box.
Regions frame(double x, double y, double width) {
  const double inner = 10, outer = inner + width;
  Loop outside;
  const Vec2 center{x, y};
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Vec2 along = direction_of(quarter * kPi / 2), up = left_of(along);
    const Vec2 corner = center + (along + up) * (outer - width / 2);
    outside.push_back(
        Edge::line(center + along * outer - up * (outer - width / 2), corner + along * (width / 2)));
    outside.push_back(
        Edge::arc(outside.back().to, corner + up * (width / 2), corner, Turn::kCounterClockwise));
  }
  for (std::size_t i = 0; i < outside.size(); ++i) outside[i].to = outside[(i + 1) % outside.size()].from;
  const std::vector<Vec2> box{
      {x - inner, y - inner}, {x - inner, y + inner}, {x + inner, y + inner}, {x + inner, y - inner}};
  return {Region::from_valid_loops(outside, {loop_from_points(box)})};
}

/// Diameter of the largest disc in such a corner, which touches the corner within and both sides outside, for a width of 1.
constexpr double kDiscInCorner = 1.1715728752538099;

/// By micrometres too narrow is too narrow: for the verifier as for the planner, whatever each allows for rounding.
TEST(OutOfReach, IsWhatIsNarrowerByMoreThanTheToleranceOfAFit) {
  for (const double lacking :
       {0.0011, 0.0015, 0.0017, 0.0018, 0.00182, 0.00185, 0.00188, 0.0019, 0.0024, 0.0027}) {
    Part part = drawn(box("POCKET_D2", -40, -40, -20, -20));
    for (const Regions& narrow : {frame(0, 0, (6 - lacking) / kDiscInCorner),
                                  Regions{rectangular_region({{40, 0}, {90, 6 - lacking}})}}) {
      Feature feature = part.features.front();
      feature.name = "NARROW_" + std::to_string(part.features.size());
      feature.target = feature.allowed = narrow;
      part.features.push_back(feature);
      part.workplan.push_back(part.workplan.front());
      part.workplan.back().feature = static_cast<int>(part.features.size()) - 1;
    }
    const auto result = plan_part(part, by_contour("endmill:6"));
    EXPECT_THAT(result.findings.faults, ::testing::IsEmpty()) << lacking << "\n"
                                                              << faults_of(result.findings);
  }
}

/// A comb of slots whose sides wave: thousands of short edges, none of which a wide cutter comes into.
Part waved_comb() {
  constexpr int kTeeth = 30, kWaves = 40;
  std::vector<Vec2> points{{0, -5}, {3.0 * kTeeth, -5}};
  for (int i = kTeeth - 1; i >= 0; --i) {
    for (int k = 0; k <= kWaves; ++k) points.push_back({3 * i + 2 + 0.1 * (k % 2), k * 0.5});
    for (int k = kWaves; k >= 0; --k) points.push_back({3 * i + 1 + 0.1 * (k % 2), k * 0.5});
  }
  Part part;
  part.name = part.source_file = "comb";
  Feature feature;
  feature.name = "COMB";
  feature.target = feature.allowed = {Region::from_valid_loops(loop_from_points(points), {})};
  feature.floor_z = -1;
  part.features = {feature};
  part.workplan.push_back({});
  return part;
}

TEST(OutOfReach, IsFoundOnOutlinesOfThousandsOfEdges) {
  const Part part = waved_comb();
  PlanOptions options = by_contour("endmill:4");
  options.strategy = "zigzag";
  const auto result = plan_part(part, options);
  ASSERT_EQ(result.findings.conditions.size(), 1u);
  EXPECT_THAT(result.findings.conditions[0].text,
              HasSubstr("the largest cutter that reaches all but 1 mm2 has 0."));
}

/// The round bottom of a hole is what a ball as wide as the hole leaves.
TEST(OutOfReach, IsNothingOfARoundBottomThatTheBallMakes) {
  Part part = drawn(box("STOCK_D30", -20, -20, 20, 20) + circle("HOLE_D12", {0, 0}, 8));
  Feature bottom = part.features.front();
  bottom.name = "bottom";
  bottom.kind = FeatureKind::kClosedPocket;
  bottom.top_z = -12;
  bottom.floor_z = -20;
  bottom.floor_fillet = 8;
  part.features.push_back(bottom);
  Workingstep step = part.workplan.front();
  step.name = step.operation.name = "bottom";
  step.feature = static_cast<int>(part.features.size()) - 1;
  part.workplan.push_back(step);
  auto options = with({"endmill:6", "ball:16"});
  options.strategy = "contour";
  const auto result = plan_part(part, options);
  for (const Condition& one : result.findings.conditions) EXPECT_NE(one.name, "out-of-reach") << one.text;
  EXPECT_FALSE(has(result.findings, FaultKind::kGouge)) << faults_of(result.findings);
}

/// What lies within the fillet is to stay: a rounder corner leaves the rest of its own. A flat end would cut the fillet away.
TEST(OutOfReach, IsWhatARounderCornerLeavesBesideTheFillet) {
  Part part = drawn(circle("POCKET_D4", {0, 0}, 20));
  part.features.front().floor_fillet = 1;
  const auto result = plan_part(part, by_contour("bullnose:8:corner=1.5"));
  ASSERT_EQ(result.findings.conditions.size(), 1u);
  const std::string text = result.findings.conditions[0].text;
  EXPECT_THAT(text, HasSubstr(": 58.9"));  // between circles of 19 and 18.5 mm
  EXPECT_THAT(text, HasSubstr("which rounds off 1.5 mm where a fillet of 1 mm is asked for"));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("flat end mill")));
}

/// A ball makes the fillet at the foot of the walls, and leaves cusps all over the floor.
TEST(OutOfReach, IsTheFloorBesideAFilletWhereABallMakesBoth) {
  Part part = drawn(box("POCKET_D4", 0, 0, 24, 20));
  part.features.front().floor_fillet = 1.5;
  const auto says = [&](const std::vector<std::string>& tools) {
    std::string text;
    for (const Condition& one : open_conditions(plan_part(part, with(tools)).findings))
      text += one.name + ": " + one.text;
    return text;
  };
  EXPECT_THAT(says({"ball:3"}), HasSubstr("which ends in a ball"));
  EXPECT_EQ(says({"bullnose:6:corner=1.5"}), "");
}

/// A flat end mill clears the floor off the fillet, and the ball makes the fillet alone; alone the mill leaves the fillet standing.
TEST(OutOfReach, IsLittleOfAFilletedFloorThatAFlatEndAndABallMake) {
  Part part = drawn(box("POCKET_D4", 0, 0, 24, 20));
  part.features.front().floor_fillet = 1.5;
  for (const bool rest : {false, true}) {
    auto options = with({"endmill:6", "ball:3"});
    options.shop.rest = rest;
    const PlanResult both = plan_part(part, options);
    EXPECT_EQ(verdict_of(both.findings), Verdict::kClean) << faults_of(both.findings);
    ASSERT_EQ(both.part.workplan.size(), 2u);
    EXPECT_EQ(verdict_of(check_program(part, both.program, "fillet.ngc", options).findings), Verdict::kClean);
    const PlanResult ball = plan_part(part, with({"ball:3"}));
    EXPECT_LT(both.findings.all.time_s, 0.8 * ball.findings.all.time_s);
  }
  const PlanResult flat = plan_part(part, with({"endmill:6"}));
  EXPECT_EQ(verdict_of(flat.findings), Verdict::kConditional) << faults_of(flat.findings);
  EXPECT_EQ(flat.findings.all.gouge_mm, 0);
}

/// At the top of a pocket less deep than its radius a ball is narrower than its distance from the walls: its passes lie nearer to each
/// other, so that nothing stands up to the top between them.
TEST(OutOfReach, OfABallInAShallowPocketIsNothingAboveTheCusps) {
  auto options = with({"ball:6"});
  options.accept = {"out-of-reach"};
  for (const double width : {16, 23}) {
    for (const char* layer : {"POCKET_D0.5", "POCKET_D2", "POCKET_D2.9", "POCKET_D4"}) {
      const auto result = plan_part(drawn(box(layer, 0, 0, width, 20)), options);
      EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << layer << faults_of(result.findings);
    }
  }
}

/// Mills with a sharper corner than the fillet keep off it at the foot of leaning walls, too.
TEST(OutOfReach, IsWhatSharperCornersLeaveOfAFilletUnderLeaningWalls) {
  for (const double draft : {5.0, 20.0, 35.0}) {
    Part part = drawn(box("POCKET_D4", 0, 0, 26, 22));
    part.features.front().floor_fillet = 2;
    part.features.front().wall_slope = Radians::of_degrees(draft);
    for (const char* tool : {"endmill:5", "bullnose:5:corner=0.5", "bullnose:6:corner=1.5"}) {
      const PlanResult result = plan_part(part, with({tool}));
      EXPECT_TRUE(result.findings.faults.empty())
          << draft << " " << tool << ": " << faults_of(result.findings);
      EXPECT_GT(result.findings.all.time_s, 0);
    }
  }
}

/// As under upright walls: the flat end clears walls and floor off the fillet, and the ball makes the fillet.
TEST(OutOfReach, IsLittleOfAFilletUnderLeaningWallsThatAFlatEndAndABallMake) {
  for (const double draft : {5.0, 20.0}) {
    Part part = drawn(box("POCKET_D4", 0, 0, 26, 22));
    part.features.front().floor_fillet = 2;
    part.features.front().wall_slope = Radians::of_degrees(draft);
    const PlanResult both = plan_part(part, with({"endmill:5", "ball:4"}));
    ASSERT_EQ(both.part.workplan.size(), 2u) << draft;
    EXPECT_EQ(verdict_of(both.findings), Verdict::kClean) << draft << verdict_and_reasons(both.findings);
  }
}

/// Steps of one rounded end beside each other touch leaning walls alike: the heights of a flat end would leave too much.
TEST(OutOfReach, IsNothingOfLeaningWallsThatARoundedEndFinishes) {
  for (const char* tool : {"ball:5", "bullnose:6:corner=2"}) {
    for (const char* finish : {"walls", "floor", "all"}) {
      Part part = drawn(box("POCKET_D5", 0, 0, 26, 22));
      part.features.front().wall_slope = Radians::of_degrees(20);
      auto options = with({tool});
      options.shop.finish = finish;
      options.accept = {"out-of-reach"};
      const PlanResult result = plan_part(part, options);
      EXPECT_EQ(verdict_of(result.findings), Verdict::kClean)
          << tool << " " << finish << ": " << verdict_and_reasons(result.findings);
    }
  }
}

}  // namespace
}  // namespace clearcut::pipeline
