// Feeds and speeds by material: rows by hand, limits that hold for random tools and machines, stated values that win.
#include "resolve/values/cutting_values.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "base/random.h"
#include "geometry/region.h"
#include "model/work_material.h"
#include "resolve/resolve.h"

namespace clearcut::resolve {
namespace {

using ::testing::HasSubstr;

Tool tool_of(ToolKind kind, double diameter, int teeth) {
  Tool tool;
  tool.kind = kind;
  tool.diameter = diameter;
  tool.teeth = teeth;
  return tool;
}

struct Filled {
  CuttingData cutting;
  FilledValues told;
  Sources sources;
};

Filled filled(const Tool& tool, const PlanOptions& options, double depth = 3, CuttingData stated = {}) {
  Operation operation;
  operation.cutting = stated;
  Filled out;
  out.told =
      fill_cutting_values(operation, tool, depth, options.shop.material.value_or(""), options, out.sources);
  out.cutting = operation.cutting;
  return out;
}

PlanOptions of(const char* material) {
  PlanOptions options;
  options.shop.material = material;
  return options;
}

TEST(CuttingValues, AreNothingWithoutAMaterial) {
  const Filled none = filled(tool_of(ToolKind::kEndMill, 6, 3), {});
  EXPECT_FALSE(none.cutting.feed || none.cutting.plunge_feed || none.cutting.spindle_rpm);
  EXPECT_TRUE(none.told.filled.empty() && none.told.warnings.empty());
}

TEST(CuttingValues, AreTheTablesRowByHand) {
  // Aluminium: 240 m/min; 0.025 mm at 3.175 mm, 0.05 at 6.35.
  const Filled mill = filled(tool_of(ToolKind::kEndMill, 6, 3), of("aluminium"));
  EXPECT_EQ(mill.cutting.spindle_rpm, 12730);        // 12732.4
  EXPECT_EQ(mill.cutting.feed, MmPerMin::of(1804));  // 0.0472441 * 3 * 12730 = 1804.3
  EXPECT_EQ(mill.cutting.plunge_feed, MmPerMin::of(1804) * 0.3);
  EXPECT_EQ(mill.sources.find("spindle")->text, "aluminium: 240 m/min (docs/feeds.md)");
  // Steel, drilled: 27 m/min of high-speed steel; 0.04 mm at 3.175 mm, 0.08 at 6.35.
  const Filled drill = filled(tool_of(ToolKind::kDrill, 5, 2), of("steel"));
  EXPECT_EQ(drill.cutting.spindle_rpm, 1710);        // 1718.9
  EXPECT_EQ(drill.cutting.feed, MmPerMin::of(107));  // 0.0629921 * 1710 = 107.7
  EXPECT_EQ(drill.cutting.plunge_feed, drill.cutting.feed);
  // Reamed: two thirds of the speed, 0.05 mm a tooth.
  const Filled reamer = filled(tool_of(ToolKind::kReamer, 6, 6), of("steel"));
  EXPECT_EQ(reamer.cutting.spindle_rpm, 950);  // 954.9
  EXPECT_EQ(reamer.cutting.feed, MmPerMin::of(285));
  // Tapped: 0.4 of the speed, 10.8 m/min; the feed is left to the pitch.
  Tool tap = tool_of(ToolKind::kTap, 6, 3);
  tap.pitch = 1;
  EXPECT_EQ(filled(tap, of("steel")).cutting.spindle_rpm, 570);  // 573
  EXPECT_FALSE(filled(tap, of("steel")).cutting.feed);
}

TEST(CuttingValues, LeaveTapsTheSpeedThatTheyNeedWhereASpindleTurnsFarTooFast) {
  Tool tap = tool_of(ToolKind::kTap, 6, 3);
  tap.pitch = 1;
  PlanOptions options = of("steel");
  options.machine.min_spindle_rpm = 8000;
  EXPECT_EQ(filled(tap, options).cutting.spindle_rpm, 570);  // refused where its feed is tied to it
  options.machine.min_spindle_rpm = 800;
  EXPECT_EQ(filled(tap, options).cutting.spindle_rpm, 800);
}

TEST(CuttingValues, KnowEdgesAndCoatings) {
  Tool tool = tool_of(ToolKind::kEndMill, 10, 4);
  const double carbide = *filled(tool, of("steel")).cutting.spindle_rpm;
  tool.high_speed_steel = true;
  EXPECT_NEAR(*filled(tool, of("steel")).cutting.spindle_rpm, carbide / 2, 10);
  tool.high_speed_steel = false;
  tool.coated = true;
  EXPECT_NEAR(*filled(tool, of("steel")).cutting.spindle_rpm, carbide * 1.2, 10);
  Tool drill = tool_of(ToolKind::kDrill, 5, 2);
  const double steel = *filled(drill, of("brass")).cutting.spindle_rpm;
  drill.high_speed_steel = false;
  EXPECT_NEAR(*filled(drill, of("brass")).cutting.spindle_rpm, 2 * steel, 20);
}

TEST(CuttingValues, MakeUpForThinChipsUnderALimitOnTheEngagement) {
  const Tool tool = tool_of(ToolKind::kEndMill, 6, 3);
  PlanOptions options = of("aluminium");
  const double full = filled(tool, options).cutting.feed->mm_per_min();
  options.engagement_deg = 90;
  EXPECT_EQ(filled(tool, options).cutting.feed->mm_per_min(), full);
  options.engagement_deg = 45;
  EXPECT_NEAR(filled(tool, options).cutting.feed->mm_per_min(), full * std::sqrt(2), 2);
  options.engagement_deg = 10;
  EXPECT_NEAR(filled(tool, options).cutting.feed->mm_per_min(), full * 2, 2);
}

TEST(CuttingValues, LeaveWhatIsStatedAndSayWhereItIsFarOff) {
  const Tool tool = tool_of(ToolKind::kEndMill, 6, 3);
  CuttingData stated;
  stated.spindle_rpm = 12000;
  stated.feed = MmPerMin::of(900);
  stated.plunge_feed = MmPerMin::of(77);
  const Filled near = filled(tool, of("aluminium"), 3, stated);
  EXPECT_EQ(near.cutting.spindle_rpm, 12000);
  EXPECT_EQ(near.cutting.feed, stated.feed);
  EXPECT_EQ(near.cutting.plunge_feed, stated.plunge_feed);
  EXPECT_TRUE(near.told.warnings.empty());
  stated.feed = MmPerMin::of(4000);
  const Filled fast = filled(tool, of("aluminium"), 3, stated);
  EXPECT_EQ(fast.cutting.feed, stated.feed);
  ASSERT_EQ(fast.told.warnings.size(), 1U);
  EXPECT_THAT(fast.told.warnings[0], HasSubstr("stated as 4000 mm/min"));
  stated.feed = MmPerMin::of(200);
  EXPECT_EQ(filled(tool, of("aluminium"), 3, stated).told.warnings.size(), 1U);
  stated.spindle_rpm = 24000;  // the feed is checked by the speed that is used: 0.0125 * 3 * 24000 = 900
  stated.feed = MmPerMin::of(900);
  EXPECT_EQ(filled(tool, of("titanium"), 3, stated).told.warnings.size(), 1U);
}

TEST(CuttingValues, SayWhereTheSpindleCannotTurnSlowlyEnough) {
  PlanOptions options = of("steel");
  options.machine.min_spindle_rpm = 8000;
  const Filled router = filled(tool_of(ToolKind::kEndMill, 10, 4), options);
  EXPECT_EQ(router.cutting.spindle_rpm, 8000);
  ASSERT_EQ(router.told.warnings.size(), 1U);
  EXPECT_THAT(router.told.warnings[0], HasSubstr("no slower than 8000 rpm"));
}

/// W at the cutter by the formula of docs/forces.md, reckoned from the feed.
double power_of(const WorkMaterial& work, const Tool& tool, double feed, double rpm, double depth) {
  const bool drills = tool.kind == ToolKind::kDrill;
  const double area = drills ? kPi * tool.radius() * tool.radius() : depth * tool.diameter;
  const double chip = drills ? feed / rpm / 2 : feed / (rpm * tool.teeth) * 2 / kPi;
  return work.kc11 * std::pow(chip, -work.mc) * area * feed / 60000;
}

void expect_within_limits(const Tool& tool, const PlanOptions& options, double depth) {
  const Machine& machine = options.machine;
  const Filled values = filled(tool, options, depth);
  ASSERT_TRUE(values.cutting.feed && values.cutting.spindle_rpm && values.cutting.plunge_feed);
  const double feed = values.cutting.feed->mm_per_min(), rpm = *values.cutting.spindle_rpm;
  EXPECT_GT(feed, 0);
  EXPECT_GT(rpm, 0);
  EXPECT_LE(values.cutting.plunge_feed->mm_per_min(), feed);
  EXPECT_LE(rpm, machine.max_spindle_rpm.value_or(24000));
  EXPECT_LE(rpm, tool.max_spindle_rpm.value_or(HUGE_VAL));
  EXPECT_LE(feed, machine.max_feed.value_or(MmPerMin::of(1e9)).mm_per_min());
  const auto work = *work_material_named(*options.shop.material);
  if (!work.has_forces()) return;
  const double power = power_of(work, tool, feed, rpm, depth);
  EXPECT_LE(power, 0.8 * machine.spindle_power_w.value_or(HUGE_VAL) * 1.000001);
  EXPECT_LE(power, 0.8 * machine.spindle_torque_nm.value_or(HUGE_VAL) * 2 * kPi * rpm / 60 * 1.000001);
}

TEST(CuttingValues, StayWithinToolAndMachineForThousandsOfThem) {
  Random random(20);
  const ToolKind kinds[] = {ToolKind::kEndMill, ToolKind::kDrill};
  const auto maybe = [&](double low, double high) {
    return random.unit() < 0.5 ? std::optional<double>(low + (high - low) * random.unit()) : std::nullopt;
  };
  for (int i = 0; i < 5000 && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    Tool tool = tool_of(kinds[i % 2], 0.2 + 40 * random.unit() * random.unit(), 1 + i % 6);
    tool.max_spindle_rpm = maybe(500, 30000);
    tool.coated = i % 3 == 0;
    if (i % 4 == 0) tool.high_speed_steel = i % 8 == 0;
    const auto& all = work_materials();
    PlanOptions options = of(all[static_cast<std::size_t>(i) % all.size()].name.c_str());
    Machine& machine = options.machine;
    machine.max_spindle_rpm = maybe(1000, 40000);
    machine.min_spindle_rpm = maybe(10, 1000);
    machine.spindle_power_w = maybe(50, 5000);
    machine.spindle_torque_nm = maybe(0.1, 50);
    if (const auto feed = maybe(10, 5000)) machine.max_feed = MmPerMin::of(*feed);
    options.engagement_deg = maybe(10, 180);
    expect_within_limits(tool, options, 0.1 + 10 * random.unit());
  }
}

Part two_steps() {
  const Vec2 corners[] = {{0, 0}, {40, 0}, {40, 30}, {0, 30}};
  Feature pocket;
  pocket.name = "POCKET";
  pocket.target = pocket.allowed = {Region::from_valid_loops(loop_from_points(corners), {})};
  pocket.floor_z = -6;
  Part part;
  part.source_file = "part.json";
  part.features = {pocket};
  part.tools = {tool_of(ToolKind::kEndMill, 6, 3)};
  Workingstep stated, unstated;
  unstated.name = "UNSTATED";
  stated.name = "STATED";
  stated.operation.cutting.feed = MmPerMin::of(5000);
  part.workplan = {unstated, stated};
  return part;
}

TEST(CuttingValues, AreAmongThePlansValuesWithTheirOrigin) {
  const StrategyTable strategies{std::vector<StrategyEntry>{}};
  const ResolvedPlan without = resolve(two_steps(), {}, strategies);
  EXPECT_EQ(without.steps[0].feed, MmPerMin::of(1000));
  PlanOptions options = of("aluminium");
  options.machine.max_feed = MmPerMin::of(1500);
  const ResolvedPlan plan = resolve(two_steps(), options, strategies);
  EXPECT_EQ(plan.steps[0].feed, MmPerMin::of(1500));
  EXPECT_EQ(plan.steps[0].spindle_rpm, 12730);
  std::string feed, material;
  for (const ResolvedValue& value : plan.values) {
    if (value.step == 0 && value.name == "feed") feed = value.source.text;
    if (value.name == "material") material = value.value;
  }
  EXPECT_EQ(feed, "aluminium: 0.0472 mm a tooth, no more than the machine's max_feed (docs/feeds.md)");
  EXPECT_EQ(material, "aluminium");
  std::string warnings;
  for (const Diagnostic& one : plan.part.diagnostics.items())
    if (one.severity == Severity::kWarning) warnings += one.what + "\n";
  EXPECT_THAT(warnings, HasSubstr("the feed of T1 is stated as 5000 mm/min"));
  ASSERT_TRUE(plan.material);
  EXPECT_FALSE(resolve(two_steps(), of("softwood"), strategies).material) << "no forces of wood are known";
}

TEST(CuttingValues, UnknownMaterialsAreRefusedWithThoseKnown) {
  try {
    check(of("unobtainium"));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("aluminium, brass, steel"));
    EXPECT_THAT(error.what(), HasSubstr("mdf"));
  }
}

}  // namespace
}  // namespace clearcut::resolve
