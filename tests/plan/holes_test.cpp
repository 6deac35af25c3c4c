// Round holes from part to certificate: drilled, reamed, pecked, bored; one word a hole where the control has it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/error.h"
#include "base/random.h"
#include "pipeline/run.h"
#include "post/part/part_writers.h"
#include "post/post.h"
#include "read/job/read_part.h"
#include "support/controllers.h"
#include "support/data.h"
#include "support/independent/rs274.h"
#include "support/plans.h"
#include "support/plate.h"

namespace clearcut {
namespace {

using test_support::expect_clean;
using test_support::plan_options_with;
using ::testing::HasSubstr;
using ::testing::Not;

Region disc(Vec2 center, double radius) {
  const Vec2 a = center + Vec2{radius, 0}, b = center - Vec2{radius, 0};
  return Region::from_valid_loops(
      {Edge::arc(a, b, center, Turn::kCounterClockwise), Edge::arc(b, a, center, Turn::kCounterClockwise)},
      {});
}

/// A whole number of steps in every control's decimals, mm and inch: rounding is another test's business.
constexpr Vec2 kCenter{2.54, -5.08};

Part part_with_hole(double diameter, double depth, FeatureKind kind = FeatureKind::kRoundHole) {
  Part part;
  part.name = "hole";
  part.source_file = "hole.json";
  part.stock = Stock{{{-40, -40}, {40, 40}}, -60, 0};
  Feature feature;
  feature.name = "HOLE";
  feature.kind = kind;
  feature.target = feature.allowed = {disc(kCenter, diameter / 2)};
  feature.floor_z = -depth;
  feature.hole_diameter = diameter;
  part.features.push_back(feature);
  part.workplan.push_back({"STEP", "", 0, {}});
  return part;
}

bool descends_on_a_helix(const Toolpath& toolpath) {
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves)
      if (move.path.is_arc() && move.z_to < move.z_from) return true;
  }
  return false;
}

TEST(Holes, ADrillOfItsSizeGoesStraightDownOnce) {
  const auto result =
      pipeline::plan_part(part_with_hole(6, 10), test_support::plan_options_with({"drill:6"}));
  expect_clean(result, "6 in 6");
  EXPECT_NEAR(result.findings.all.plunge_mm, 11, 1e-6);
  EXPECT_THAT(result.program, HasSubstr("G98 G81 X2.54 Y-5.08 Z-10 R1 F"));
  ASSERT_EQ(result.findings.features.size(), 1u);
  EXPECT_EQ(result.findings.features[0].layers.size(), 1u) << "a drilled hole counts as one layer";
}

TEST(Holes, DeepOnesArePeckedAndTheControlSaysSoInOneBlock) {
  const auto result =
      pipeline::plan_part(part_with_hole(6, 30), test_support::plan_options_with({"drill:6"}));
  expect_clean(result, "6 mm, 30 deep");
  EXPECT_THAT(result.program, HasSubstr("G98 G83 X2.54 Y-5.08 Z-30 R1 Q6 F"));
}

TEST(Holes, EveryControlMakesTheSameHole) {
  for (const test_support::Controller& one : test_support::controllers()) {
    const std::string dialect(one.name);
    for (const bool inch : {false, true}) {
      PlanOptions options = test_support::plan_options_with({"drill:6"});
      options.post.dialect = dialect;
      options.post.inch = inch;
      const auto result = pipeline::plan_part(part_with_hole(6, 30), options);
      expect_clean(result, dialect);
      EXPECT_NEAR(result.findings.all.plunge_mm, 31 + 5 * 0.254, 0.5) << dialect;
      const std::string_view pecks = one.pecks.empty() ? "G83" : one.pecks;
      EXPECT_EQ(result.program.find(pecks) != std::string::npos, !one.pecks.empty()) << dialect;
    }
  }
}

TEST(Holes, TheControlsOwnInterpreterDrillsAsWeRead) {
  CLEARCUT_SKIP_WITHOUT_RS274();
  const auto result =
      pipeline::plan_part(part_with_hole(6, 30), test_support::plan_options_with({"drill:6"}));
  const auto canon = test_support::run_rs274(result.program);
  ASSERT_TRUE(canon.accepted) << canon.message;
  double lowest = 0;
  for (const auto& move : canon.moves) lowest = std::min(lowest, move.z);
  EXPECT_NEAR(lowest, -30, 1e-6);
}

TEST(Holes, TheDrillIsPreferredToAMillAndUsedForHolesOnly) {
  Part part = part_with_hole(6, 10);
  Feature pocket;
  pocket.name = "POCKET";
  pocket.target = pocket.allowed = {Region::from_valid_loops(
      loop_from_points(std::vector<Vec2>{{10, 10}, {30, 10}, {30, 30}, {10, 30}}), {})};
  pocket.floor_z = -3;
  part.features.push_back(pocket);
  part.workplan.push_back({"POCKETING", "", 1, {}});
  const auto result = pipeline::plan_part(
      part, test_support::plan_options_with({"endmill:5:T1", "drill:6:T2", "drill:8:T3"}));
  expect_clean(result, "drill and mill");
  EXPECT_EQ(result.findings.features[0].tool_number, 2);
  EXPECT_EQ(result.findings.features[1].tool_number, 1);
}

TEST(Holes, ADrillNeverMills) {
  Part part = part_with_hole(12, 4);
  const auto refusal = [&] {
    try {
      pipeline::plan_part(part, test_support::plan_options_with({"drill:6"}));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(refusal(), HasSubstr("(drill 6 mm) makes no hole of 12 mm"));
  part.features[0].target = part.features[0].allowed = {
      Region::from_valid_loops(loop_from_points(std::vector<Vec2>{{0, 0}, {20, 0}, {20, 20}, {0, 20}}), {})};
  part.features[0].kind = FeatureKind::kClosedPocket;
  EXPECT_THAT(refusal(), HasSubstr("only makes round holes; HOLE needs a mill"));
}

TEST(Holes, SmallerMillsBoreAlongAHelixAndCloseTheFloor) {
  Random random(7);
  for (int i = 0; i < 40; ++i) {
    const double tool = random.between(2, 12), hole = tool * random.between(1.12, 1.9);
    const auto result =
        pipeline::plan_part(part_with_hole(hole, random.between(1, 20)),
                            test_support::plan_options_with({"endmill:" + std::to_string(tool)}));
    expect_clean(result, std::to_string(tool) + " in " + std::to_string(hole));
    EXPECT_TRUE(descends_on_a_helix(result.toolpath)) << tool << " in " << hole;
    EXPECT_LE(result.findings.all.max_axial_mm, tool / 2 + 0.01);
  }
}

TEST(Holes, BoringClimbsWithTheSpindleEitherWayRound) {
  for (const bool clockwise : {true, false}) {
    PlanOptions options = test_support::plan_options_with({"endmill:6"});
    Part part = part_with_hole(10, 6);
    part.workplan[0].operation.cutting.spindle_clockwise = clockwise;
    const auto result = pipeline::plan_part(part, options);
    expect_clean(result, "10 by 6");
    for (const Move& move : result.toolpath.sections[0].moves) {
      if (!move.path.is_arc()) continue;
      EXPECT_EQ(move.path.turn, clockwise ? Turn::kCounterClockwise : Turn::kClockwise);
    }
  }
}

TEST(Holes, StockIsLeftInABore) {
  PlanOptions options = test_support::plan_options_with({"endmill:6"});
  options.allowance = 0.25;
  const auto result = pipeline::plan_part(part_with_hole(10, 6), options);
  expect_clean(result, "with stock to leave");
  double farthest = 0;
  for (const Move& move : result.toolpath.sections[0].moves)
    farthest = std::max(farthest, distance(move.path.to, kCenter));
  EXPECT_NEAR(farthest, 1.75, 0.001);
}

TEST(Holes, WideOnesAreClearedLikePockets) {
  const auto result =
      pipeline::plan_part(part_with_hole(30, 6), test_support::plan_options_with({"endmill:6"}));
  expect_clean(result, "30 by 6");
}

TEST(Holes, AStepNcPlateIsDrilledReamedAndClean) {
  const auto plate = pipeline::plan_part(
      read::read_part_text(post::write_stepnc(test_support::plate()), "plate.p21", {}), {});
  expect_clean(plate, "plate");
  EXPECT_THAT(plate.program, HasSubstr("X20 Y10 Z-10"));
  EXPECT_THAT(plate.program, Not(HasSubstr("SKIPPED")));
  EXPECT_EQ(plate.findings.features[0].tool_diameter, 11.8);
  EXPECT_EQ(plate.findings.features[1].tool_diameter, 12);
}

/// Published files, where they are; they only add to the plate above.
TEST(Holes, PublishedSamplesAreDrilledReamedAndClean) {
  const auto data = test_support::data_folder();
  if (!data) return;
  // Its T3 has flutes of 9 mm for a step 12 mm deep: left out by name, and cut with a longer tool.
  Part part = read::read_part(*data / "stepnc/ufsc_hole_slot_step_pocket.p21", {});
  EXPECT_FALSE(pipeline::plan_part(part, {}).findings.all.clean);
  for (Tool& tool : part.tools) tool.flute_length.reset();
  const auto sample = pipeline::plan_part(part, {});
  expect_clean(sample, "ufsc");
  EXPECT_THAT(sample.program, HasSubstr("G81 X20 Y10 Z30"));
  EXPECT_THAT(sample.program, Not(HasSubstr("SKIPPED")));
  Part example = read::read_part(*data / "stepnc/iso14649_11_ex1_nist.stp", {});
  for (Tool& tool : example.tools) tool.flute_length.reset();  // 29 mm for a pocket 30 mm deep
  const auto reamed = pipeline::plan_part(example, {});
  expect_clean(reamed, "example 1");
  EXPECT_EQ(reamed.findings.features[1].tool_diameter, 20);
  EXPECT_EQ(reamed.findings.features[2].tool_diameter, 22);
}

/// A pocket round a hole that is drilled before it.
Part pocket_with_drilled_hole(double drill, double hole_depth) {
  Part part = part_with_hole(8, hole_depth);
  Feature pocket;
  pocket.name = "POCKET";
  const Vec2 corners[] = {{-30, -20}, {30, -20}, {30, 20}, {-30, 20}};
  pocket.target = pocket.allowed = {Region::from_valid_loops(loop_from_points(corners), {})};
  pocket.floor_z = -6;
  part.features.push_back(pocket);
  part.workplan.push_back({"POCKET", "", 1, {}});
  Tool mill;
  mill.diameter = 6;
  mill.center_cutting = false;
  part.tools = {test_support::plan_options_with({"drill:" + std::to_string(drill) + ":T2"}).tools.front(),
                mill};
  part.workplan[0].operation.tool = 0;
  part.workplan[1].operation.tool = 1;
  part.workplan[1].operation.entry = EntryKind::kPlunge;
  return part;
}

/// Ways of the mill down into the pocket beside the hole.
int entries_beside_hole(const PlanResult& result) {
  int beside = 0;
  for (const Section& section : result.toolpath.sections) {
    if (section.tool_number != 1) continue;
    for (const Move& move : section.moves) {
      const bool down = !is_rapid(move.kind) && move.z_to < move.z_from;
      beside += down && distance(move.path.from, kCenter) > 1.001;
    }
  }
  return beside;
}

TEST(Holes, ADrilledHoleIsTheWayDownIntoThePocketRoundIt) {
  for (const std::string strategy : {"contour", "zigzag", "spiral", "adaptive", "tour", "auto"}) {
    PlanOptions options;
    options.strategy = strategy;
    // As deep as the pocket, and by the drill's point deeper.
    const auto result = pipeline::plan_part(pocket_with_drilled_hole(8, 8.5), options);
    expect_clean(result, strategy);
    EXPECT_EQ(entries_beside_hole(result), 0) << strategy;
  }
}

/// Too shallow is one, too, in which the cone of the drill stands over the pocket's floor.
TEST(Holes, AHoleThatIsTooShallowOrTooNarrowIsNoWayDown) {
  PlanOptions options;
  options.strategy = "contour";
  for (const Part& part :
       {pocket_with_drilled_hole(8, 4), pocket_with_drilled_hole(8, 6), pocket_with_drilled_hole(5, 8.5)}) {
    const auto result = pipeline::plan_part(part, options);
    EXPECT_GT(entries_beside_hole(result), 0);
  }
}

}  // namespace
}  // namespace clearcut
