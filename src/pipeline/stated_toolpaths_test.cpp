// Toolpaths that a STEP-NC program states, planned as they stand; and written back, so that reading gives the same moves.
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/error.h"
#include "base/random.h"
#include "pipeline/run.h"
#include "pipeline/test_drawings.h"
#include "post/part/stepnc_setups.h"
#include "read/job/read_part.h"
#include "read/stepnc/stepnc.h"
#include "report/result.h"

namespace clearcut::pipeline {
namespace {

Loop box_at(Vec2 low, Vec2 size) {
  return loop_from_points(std::vector<Vec2>{low, low + Vec2{size.x, 0}, low + size, low + Vec2{0, size.y}});
}

Loop circle_at(Vec2 center, double radius) {
  const Vec2 a = center + Vec2{radius, 0}, b = center - Vec2{radius, 0};
  return {Edge::arc(a, b, center, Turn::kCounterClockwise), Edge::arc(b, a, center, Turn::kCounterClockwise)};
}

Feature closed(const std::string& name, Regions target, double top, double floor) {
  Feature feature;
  feature.name = name;
  feature.target = feature.allowed = std::move(target);
  feature.top_z = top;
  feature.floor_z = floor;
  return feature;
}

const Box kPlateBox{{0, 0}, {120, 80}};

/// On a block 120 x 80 x 20 with its top at z 0.
Part part_of(const std::vector<Feature>& features, const std::vector<int>& tools) {
  Part part;
  part.name = "written";
  part.source_file = "written.p21";
  part.stock = Stock{kPlateBox, -20, 0};
  for (const char* tool : {"endmill:8:T1", "drill:5:T2", "bullnose:6:corner=0.5:T3"})
    part.tools.push_back(resolve::parse_tool(tool));
  part.features = features;
  for (std::size_t i = 0; i < features.size(); ++i) {
    Workingstep step;
    step.name = "WS " + features[i].name;
    step.feature = static_cast<int>(i);
    step.operation.name = "OP " + features[i].name;
    step.operation.tool = tools[i];
    step.operation.kind = features[i].hole_diameter ? OperationKind::kDrilling : OperationKind::kRoughing;
    part.workplan.push_back(step);
  }
  return part;
}

Feature drilled(const std::string& name, Vec2 center, double floor) {
  Feature hole = closed(name, {Region::from_valid_loops(circle_at(center, 2.5), {})}, 0, floor);
  hole.kind = FeatureKind::kRoundHole;
  hole.hole_diameter = 5;
  return hole;
}

/// A pocket with an island, one of two regions, and a hole.
Part plate() {
  const Loop island = circle_at({30, 30}, 6.3);
  return part_of(
      {closed("POCKET", {Region::from_valid_loops(box_at({8, 8}, {47.3, 41.7}), {reversed(island)})}, 0,
              -7.3),
       closed("TWO",
              {Region::from_valid_loops(box_at({70, 10}, {20, 15}), {}),
               Region::from_valid_loops(circle_at({100, 55}, 9), {})},
              0, -4.1),
       drilled("HOLE", {80.123, 65.457}, -9)},
      {0, 2, 1});
}

void expect_same_program(const Part& part, const PlanOptions& options, const std::string& what) {
  const PlanResult first = plan_part(part, options);
  const std::string text = post::write_stepnc(first.part, first.planned);
  const Part read = read::read_part_text(text, "again.p21", {});
  const PlanResult again = plan_part(read, options);
  EXPECT_EQ(report::motion_text(again.program), report::motion_text(first.program)) << what;
  EXPECT_EQ(verdict_of(again.findings), verdict_of(first.findings))
      << what << verdict_and_reasons(again.findings);
}

TEST(StatedToolpathPlans, WhatIsWrittenBackGivesTheSameProgram) {
  expect_same_program(plate(), {}, "plate");
}

TEST(StatedToolpathPlans, HelicesAndLeadsComeBackAsTheyWere) {
  PlanOptions options;
  options.entry = EntryKind::kHelix;
  options.lead = 1.5;
  expect_same_program(plate(), options, "helix");
}

/// What drawings ask for beyond pockets and holes, each by a cutter of its own.
TEST(StatedToolpathPlans, EdgesGroovesThreadsAndProfilesComeBackAsTheyWere) {
  struct Row {
    const char* what;
    std::string entities;
    std::vector<std::string> tools;
  };
  const std::string pocket = box("POCKET_D4", 12, 12, 48, 32), stock = box("STOCK_D10", 0, 0, 60, 44);
  const std::string blunt = "chamfer:90deg:8:tip=0.4";
  const Row rows[] = {
      {"chamfer of a pocket", stock + pocket + box("CHAMFER_D0.5", 12, 12, 48, 32), {"endmill:5", blunt}},
      {"chamfer by a V-bit",
       stock + pocket + box("CHAMFER_D0.5", 12, 12, 48, 32),
       {"endmill:5", "vbit:60deg:6"}},
      {"groove of a cone", stock + circle("ENGRAVE_D1", {30, 22}, 9), {"vbit:60deg:6"}},
      {"groove of a ball", stock + circle("ENGRAVE_D1.5", {30, 22}, 9), {"ball:4"}},
      {"engraving", stock + circle("ENGRAVE_D1", {30, 22}, 9), {"endmill:2"}},
      {"profile", rounded_box("PROFILE_D6", 0, 0, 50, 30, 5), {"endmill:5"}},
      {"countersink",
       box("STOCK_D20", 0, 0, 60, 44) + circle("DRILL_D8", {30, 22}, 2.5) +
           circle("COUNTERSINK_D2", {30, 22}, 4),
       {"drill:5", "chamfer:90deg:10"}},
      {"tapped thread",
       box("STOCK_D20", 0, 0, 60, 44) + circle("TAP_M6_D8", {30, 22}, 2.5),
       {"drill:5", "tap:M6"}},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.what);
    expect_same_program(drawn(row.entities), with(row.tools), row.what);
  }
}

TEST(StatedToolpathPlans, OthersThanTheFilesArePlannedWhereAsked) {
  const PlanResult first = plan_part(plate(), {});
  const Part read = read::read_part_text(post::write_stepnc(first.part, first.planned), "again.p21", {});
  PlanOptions options;
  options.toolpaths = ToolpathSource::kOurs;
  options.accept = {"out-of-reach"};
  options.strategy = "zigzag";
  const PlanResult again = plan_part(read, options);
  EXPECT_NE(report::motion_text(again.program), report::motion_text(first.program));
  EXPECT_EQ(verdict_of(again.findings), Verdict::kClean) << verdict_and_reasons(again.findings);
}

/// Random pockets with islands, and holes, beside each other, on the block with its lower left corner and its top there.
Part random_part(Random& random, Vec2 corner = {}, double top = 0) {
  std::vector<Feature> features;
  std::vector<int> tools;
  for (int i = 0; i < 3; ++i) {
    const Vec2 low = corner + Vec2{5.0 + 38 * i, 5 + 10 * random.unit()};
    const Vec2 size{24 + 10 * random.unit(), 24 + 30 * random.unit()};
    const double floor = top - 1 - 8 * random.unit();
    const std::string name = "F" + std::to_string(i);
    if (random.unit() < 0.25) {
      features.push_back(drilled(name, low + Vec2{10, 10} * (1 + random.unit()), floor));
      features.back().top_z = top;
      tools.push_back(1);
      continue;
    }
    std::vector<Loop> islands;
    if (random.unit() < 0.3) islands.push_back(reversed(circle_at(low + size * 0.5, 1 + 2 * random.unit())));
    const Loop outline = random.unit() < 0.3 ? circle_at(low + size * 0.5, size.x / 2) : box_at(low, size);
    features.push_back(closed(name, {Region::from_valid_loops(outline, islands)}, top, floor));
    tools.push_back(random.unit() < 0.5 ? 0 : 2);
  }
  Part part = part_of(features, tools);
  part.stock = Stock{{kPlateBox.min + corner, kPlateBox.max + corner}, top - 20, top};
  return part;
}

TEST(StatedToolpathPlans, RandomPartsComeBackToTheDigit) {
  const char* count = std::getenv("CLEARCUT_ROUND_TRIPS");
  const int parts = count != nullptr ? std::atoi(count) : 3;
  Random random(7);
  for (int i = 0; i < parts; ++i) {
    PlanOptions options;
    if (random.unit() < 0.5) options.entry = EntryKind::kHelix;
    if (random.unit() < 0.3) options.lead = 1;
    if (random.unit() < 0.3) options.post.inch = true;
    expect_same_program(random_part(random), options, "part " + std::to_string(i));
  }
}

/// The block about the origin, so that it lies as before when it is turned over.
WrittenSetup random_setup(Random& random, const SetupPlace& place) {
  const PlanResult result = plan_part(random_part(random, kPlateBox.max * -0.5, 10), {});
  return {result.part, result.planned, place};
}

TEST(StatedToolpathPlans, SeveralSetupsComeBackToTheDigit) {
  const char* count = std::getenv("CLEARCUT_ROUND_TRIPS");
  const int parts = count != nullptr ? std::atoi(count) : 1;
  Random random(11);
  for (int i = 0; i < parts; ++i) {
    const SetupPlace over = *place_with_up("-Z", random.unit() < 0.5 ? 0 : 180);
    const std::vector<WrittenSetup> setups{random_setup(random, {}), random_setup(random, over)};
    const std::string text = post::write_stepnc(setups);
    for (int number = 1; number <= 2; ++number) {
      SetupPlace place;
      const Part read = read::stepnc::read_setup(text, "again.p21", {}, number, place);
      const WrittenSetup& written = setups[static_cast<std::size_t>(number - 1)];
      EXPECT_EQ(place.turn, written.place.turn);
      const PlanResult first = plan_part(written.part, {}), again = plan_part(read, {});
      EXPECT_EQ(report::motion_text(again.program), report::motion_text(first.program))
          << "part " << i << ", set-up " << number;
      EXPECT_EQ(verdict_of(again.findings), verdict_of(first.findings));
    }
  }
}

TEST(StatedToolpathPlans, SetupsWithZerosOfTheirOwnAreRefused) {
  Random random(3);
  std::vector<WrittenSetup> setups{random_setup(random, {}), random_setup(random, {})};
  setups.back().place.shift = {5, 0, 0};
  EXPECT_THROW(post::write_stepnc(setups), InputError);
}

/// One trajectory on the floor of a pocket 20 x 8 by a cutter of 8: nothing else is needed but the way down.
const char* const kSlotProgram = R"(ISO-10303-21;
HEADER;
FILE_SCHEMA(('MACHINING_SCHEMA'));
ENDSEC;
DATA;
#1=PROJECT('P',#2,(#3),$,$,$);
#2=WORKPLAN('MAIN',(#10),$,#4,$);
#3=WORKPIECE('WP',$,$,$,$,#5,());
#4=SETUP('S',$,#7,(#9));
#5=BLOCK('B',$,60.,40.,20.);
#7=PLANE('SECURITY',#8);
#8=AXIS2_PLACEMENT_3D('',#61,$,$);
#61=CARTESIAN_POINT('',(0.,0.,30.));
#9=WORKPIECE_SETUP(#3,$,$,$,());
#10=MACHINING_WORKINGSTEP('WS1',#7,#20,#30,$);
#20=SLOT('SLOT',#3,(#30),#21,#23,#40,#43,(#44,#44));
#21=AXIS2_PLACEMENT_3D('',#22,$,$);
#22=CARTESIAN_POINT('',(20.,20.,20.));
#23=PLANE('DEPTH',#24);
#24=AXIS2_PLACEMENT_3D('',#25,$,$);
#25=CARTESIAN_POINT('',(0.,0.,-2.));
#30=BOTTOM_AND_SIDE_ROUGH_MILLING(#80,$,'OP',8.,$,#31,#34,$,$,$,$,STRATEGY,2.,$,$,$);
#31=MILLING_CUTTING_TOOL('T5',#32,(),$,$,$);
#32=ENDMILL(#33,3,.RIGHT.,$,$);
#33=MILLING_TOOL_DIMENSION(8.,$,$,25.,0.,$,$);
#34=MILLING_TECHNOLOGY(0.01,.TCP.,$,-100.,$,$,$,$,$);
#37=EXPLICIT_STRATEGY($,$);
#40=LINEAR_PATH($,#41,#42);
#41=TOLERANCED_LENGTH_MEASURE(20.,$);
#42=DIRECTION('',(1.,0.,0.));
#43=SQUARE_U_PROFILE($,#45,$,$,$,$);
#44=RADIUSED_SLOT_END_TYPE();
#45=TOLERANCED_LENGTH_MEASURE(8.,$);
#80=TOOLPATH_LIST((#81,#82));
#81=CUTTER_LOCATION_TRAJECTORY(.T.,.CONTACT.,$,$,$,$,#85,$,$);
#82=FEEDSTOP(.T.,.CONTACT.,$,$,$,0.5);
#85=POLYLINE('',(#90,#91));
#90=CARTESIAN_POINT('',(0.,0.,-2.));
#91=CARTESIAN_POINT('',(20.,0.,-2.));
ENDSEC;
END-ISO-10303-21;
)";

Part slot(const std::string& strategy) {
  std::string text = kSlotProgram;
  text.replace(text.find("STRATEGY"), 8, strategy);
  return read::read_part_text(text, "slot.p21", {});
}

int count_of(const std::string& text, const std::string& word) {
  int count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(StatedToolpathPlans, OneTrajectoryIsLinkedAndCertified) {
  const PlanResult plan = plan_part(slot("#37"), {});
  EXPECT_EQ(verdict_and_reasons(plan.findings), "CLEAN\n");
  EXPECT_NE(plan.program.find("G4 P0.5"), std::string::npos) << plan.program;
  ASSERT_EQ(plan.toolpath.sections.size(), 1U);
  int cuts = 0;
  for (const Move& move : plan.toolpath.sections[0].moves) cuts += move.kind == MoveKind::kCut;
  EXPECT_EQ(cuts, 1);
}

/// The default of half the diameter is not asked of a path that goes deeper at once.
TEST(StatedToolpathPlans, WithoutACuttingDepthTheLayersAreThoseOfThePath) {
  std::string text = kSlotProgram;
  for (const char* z : {"(0.,0.,-2.)", "(0.,0.,-2.)", "(20.,0.,-2.)"})
    if (const std::size_t at = text.find(z); at != std::string::npos)
      text.replace(text.find("-2.)", at), 4, "-6.)");
  text.replace(text.find("STRATEGY,2."), 11, "#37,$");
  const PlanResult deep = plan_part(read::read_part_text(text, "slot.p21", {}), {});
  EXPECT_EQ(verdict_and_reasons(deep.findings), "CLEAN\n");
}

TEST(StatedToolpathPlans, ATrajectoryThatIsNotUsedIsSaid) {
  const PlanResult plan = plan_part(slot("$"), {});
  EXPECT_EQ(verdict_of(plan.findings), Verdict::kConditional);
  EXPECT_EQ(count_of(verdict_and_reasons(plan.findings), "--toolpaths file uses it"), 1);
  PlanOptions options;
  options.toolpaths = ToolpathSource::kFile;
  EXPECT_EQ(verdict_and_reasons(plan_part(slot("$"), options).findings), "CLEAN\n");
  options.toolpaths = ToolpathSource::kOurs;
  EXPECT_EQ(verdict_and_reasons(plan_part(slot("$"), options).findings), "CLEAN\n");
}

}  // namespace
}  // namespace clearcut::pipeline
