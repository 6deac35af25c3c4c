#include "resolve/resolve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "geometry/region.h"
#include "resolve/values/names.h"

namespace clearcut::resolve {
namespace {

using ::testing::HasSubstr;

const StrategyTable& table() {
  static const StrategyTable strategies = [] {
    std::vector<StrategyEntry> all;
    for (const char* name : {"zigzag", "spiral", "contour"}) all.emplace_back().name = name;
    return StrategyTable(std::move(all));
  }();
  return strategies;
}

Part pocket() {
  const Vec2 corners[] = {{0, 0}, {40, 0}, {40, 30}, {0, 30}};
  Feature feature;
  feature.name = "POCKET";
  feature.target = feature.allowed = {Region::from_valid_loops(loop_from_points(corners), {})};
  feature.floor_z = -6;
  Part part;
  part.source_file = "/somewhere/bracket.p21";
  part.features = {feature};
  part.tools.emplace_back().diameter = 8;
  Workingstep step;
  step.name = "STEP";
  step.operation.source = "#123";
  part.workplan = {step};
  return part;
}

/// The value of the first step, or with step -1 of the whole plan.
ResolvedValue value_of(const ResolvedPlan& plan, const std::string& name, int step = 0) {
  for (const ResolvedValue& value : plan.values)
    if (value.name == name && value.step == step) return value;
  ADD_FAILURE() << "no value " << name;
  return {};
}

void expect_value(const ResolvedPlan& plan, const std::string& name, const std::string& text, Origin origin,
                  const std::string& source, int step = 0) {
  const ResolvedValue value = value_of(plan, name, step);
  EXPECT_EQ(value.value, text) << name;
  EXPECT_STREQ(name_of(value.source.origin), name_of(origin)) << name;
  EXPECT_EQ(value.source.text, source) << name;
}

/// What is stated counts first, then the user's material, then that of the input.
TEST(Resolve, TheInputsMaterialGivesFeedsThatNobodyStates) {
  const auto resolved = [](std::optional<const char*> of_input, std::optional<const char*> of_user,
                           std::optional<double> feed = {}, std::optional<double> rpm = {}) {
    Part part = pocket();
    if (of_input) part.material = *of_input;
    if (feed) part.workplan[0].operation.cutting.feed = MmPerMin::of(*feed);
    part.workplan[0].operation.cutting.spindle_rpm = rpm;
    PlanOptions options;
    if (of_user) options.shop.material = *of_user;
    options.shop.style = "fastest";
    return resolve(part, options, table());
  };
  const ResolvedPlan aluminium = resolved({}, "aluminium"), steel = resolved({}, "steel");
  ASSERT_FALSE(aluminium.steps[0].feed == steel.steps[0].feed);
  const auto expect_same = [](const ResolvedPlan& a, const ResolvedPlan& b) {
    EXPECT_EQ(a.steps[0].feed, b.steps[0].feed);
    EXPECT_EQ(a.steps[0].plunge_feed, b.steps[0].plunge_feed);
    EXPECT_EQ(a.steps[0].spindle_rpm, b.steps[0].spindle_rpm);
  };
  expect_same(resolved("steel", {}), steel);
  expect_same(resolved("aluminium", "steel"), steel);
  expect_same(resolved("steel", {}, 700, 5000), resolved({}, {}, 700, 5000));
  expect_same(resolved("steel", {}, 700), resolved({}, "steel", 700));
  expect_same(resolved("steel", {}, {}, 5000), resolved({}, "steel", {}, 5000));
  EXPECT_THAT(value_of(resolved("steel", {}), "feed").source.text, HasSubstr("steel: "));
}

TEST(Resolve, DecidesEveryDefaultAndSaysSo) {
  const ResolvedPlan plan = resolve(pocket(), {}, table());
  ASSERT_EQ(plan.steps.size(), 1U);
  EXPECT_EQ(plan.steps[0].feed, MmPerMin::of(1000));
  EXPECT_EQ(plan.steps[0].slot_feed, plan.steps[0].feed);
  EXPECT_EQ(plan.steps[0].strategy, nullptr);
  expect_value(plan, "feed", "1000", Origin::kDefault, "default: 1000 mm/min");
  expect_value(plan, "plunge-feed", "300", Origin::kDerived, "30 % of the feed");
  expect_value(plan, "stepdown", "4", Origin::kDefault, "default: half the diameter");
  expect_value(plan, "strategy", "auto", Origin::kDefault, "default: the fastest that is certified clean");
  expect_value(plan, "seed", "1", Origin::kDefault, "default: 1", -1);
  expect_value(plan, "tool", "T1 endmill 8", Origin::kPart, "bracket.p21 #123");
}

TEST(Resolve, NoSpindleIsAskedForMoreThanIsUsualOrStated) {
  Part part = pocket();
  part.tools = {parse_tool("endmill:0.2:T1")};
  PlanOptions options;
  EXPECT_EQ(resolve(part, options, table()).steps[0].spindle_rpm, 24000) << "100 m/min are 159 150 rpm";
  options.machine.max_spindle_rpm = 60000;
  EXPECT_EQ(resolve(part, options, table()).steps[0].spindle_rpm, 60000);
  part.tools = {parse_tool("endmill:8:T1")};
  EXPECT_EQ(resolve(part, options, table()).steps[0].spindle_rpm, 3980);
}

TEST(Resolve, WhatOnlyPlungesNeedsNoOtherFeed) {
  Part part = pocket();
  part.tools = {parse_tool("spotdrill:8:90deg:T1")};
  part.workplan[0].operation.cutting.plunge_feed = MmPerMin::of(120);
  const ResolvedPlan plan = resolve(part, {}, table());
  expect_value(plan, "feed", "120", Origin::kDerived, "the plunge feed: the tool only plunges");
}

TEST(Resolve, OptionsGoBeforeThePart) {
  Part part = pocket();
  part.workplan[0].operation.cutting.feed = MmPerMin::of(700);
  part.workplan[0].operation.stepdown = 1.5;
  PlanOptions options;
  options.stepdown = 3;
  const ResolvedPlan plan = resolve(part, options, table());
  expect_value(plan, "feed", "700", Origin::kPart, "bracket.p21 #123");
  expect_value(plan, "stepdown", "3", Origin::kUser, "--stepdown");
  EXPECT_EQ(plan.steps[0].stepdown, 3);
}

TEST(Resolve, AJobsValuesSayTheirLine) {
  Part part = pocket();
  part.workplan[0].operation.cutting.feed = MmPerMin::of(700);
  PlanOptions options;
  options.step_sources[step_key(part.workplan[0])].set("feed", {Origin::kJobFile, "job.toml:12"});
  const ResolvedPlan plan = resolve(part, options, table());
  expect_value(plan, "feed", "700", Origin::kJobFile, "job.toml:12");
}

TEST(Resolve, TheMachineLimitsTheFeed) {
  PlanOptions options;
  options.machine.max_feed = MmPerMin::of(600);
  options.sources.set("max-feed", {Origin::kMachineFile, "mill.toml:3"});
  const ResolvedPlan plan = resolve(pocket(), options, table());
  expect_value(plan, "feed", "600", Origin::kDerived, "the machine's max_feed");
  expect_value(plan, "max-feed", "600", Origin::kMachineFile, "mill.toml:3", -1);
}

TEST(Resolve, EachStepHasTheStrategyThatItsFileNames) {
  Part part = pocket();
  part.workplan.push_back(part.workplan[0]);
  part.workplan.push_back(part.workplan[0]);
  part.workplan[0].operation.strategy_hint = "contour_parallel";
  part.workplan[1].operation.strategy_hint = "bidirectional_milling";
  part.workplan[1].operation.feed_direction = Radians::of_degrees(30);
  part.workplan[2].operation.strategy_hint = "center_milling";
  part.workplan[2].name = "GROOVE";
  ResolvedPlan plan = resolve(part, {}, table());
  EXPECT_EQ(plan.steps[0].strategy, table().find("contour"));
  EXPECT_EQ(plan.steps[1].strategy, table().find("zigzag"));
  EXPECT_EQ(plan.steps[1].stroke_angle, Radians::of_degrees(30));
  EXPECT_EQ(plan.steps[2].strategy, nullptr);
  std::string said;
  for (const auto& one : plan.part.diagnostics.items())
    if (one.where == "GROOVE") said = one.what;
  EXPECT_THAT(said, HasSubstr("center_milling is not among ours"));
  PlanOptions options;
  options.strategy = "spiral";
  plan = resolve(part, options, table());
  for (const ResolvedStep& step : plan.steps) EXPECT_EQ(step.strategy, table().find("spiral"));
}

TEST(Resolve, RefusesAStrategyOfAJobThatIsNoneInOneLine) {
  Part part = pocket();
  part.workplan[0].operation.strategy_hint = "nonsense";
  PlanOptions options;
  options.step_sources[step_key(part.workplan[0])].set("strategy", {Origin::kJobFile, "job.toml:7"});
  try {
    resolve(part, options, table());
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "job.toml:7: strategy 'nonsense' is unknown; use one of auto, zigzag, spiral, contour");
  }
}

TEST(Resolve, AStepoverOfOneOperationIsForThatOperation) {
  Part part = pocket();
  part.workplan.push_back(part.workplan[0]);
  part.workplan[1].name = "OTHER";
  part.workplan[1].operation.stepover = 0.25;
  PlanOptions options;
  options.stepover = "0.5";
  options.sources.set("stepover", {Origin::kJobFile, "job.toml:3"});
  options.step_sources[step_key(part.workplan[0])].set("stepover", {Origin::kJobFile, "job.toml:3"});
  options.step_sources[step_key(part.workplan[1])].set("stepover", {Origin::kJobFile, "job.toml:9"});
  ResolvedPlan plan = resolve(part, options, table());
  EXPECT_EQ(plan.steps[0].stepover.text, "0.5");
  EXPECT_EQ(plan.steps[1].stepover.text, "0.25");
  options.sources.set("stepover", {Origin::kUser, "--stepover"});
  plan = resolve(part, options, table());
  EXPECT_EQ(plan.steps[1].stepover.text, "0.5");
}

TEST(Resolve, RefusesAnObjectiveThatIsNone) {
  PlanOptions options;
  options.objective = "beauty";
  EXPECT_THROW(resolve(pocket(), options, table()), InputError);
}

TEST(Resolve, RefusesMoreWorkingstepsThanArePlannedAtOnce) {
  Part part = pocket();
  part.workplan.resize(20001, part.workplan.front());
  try {
    resolve(part, {}, table());
    ADD_FAILURE() << "not refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("20001 workingsteps"), std::string::npos) << error.what();
  }
}

TEST(Names, AreRefusedWithTheNamesThereAre) {
  EXPECT_EQ(entry_named("zigzag", "--entry"), EntryKind::kZigzagRamp);
  EXPECT_EQ(direction_named("conventional", "--direction"), CutDirection::kConventional);
  try {
    order_named("sideways", "--order");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "--order: 'sideways' is unknown; use one of inside-out, outside-in");
  }
}

TEST(Resolve, FeaturesAboveTheMaterialAreRefused) {
  const auto refusal = [](double top, double floor, FeatureKind kind) -> std::string {
    Part part = pocket();
    part.stock = Stock{box(part.features[0].target), -20, 0};
    part.features[0].kind = kind;
    part.features[0].source = "#30";
    part.features[0].top_z = top;
    part.features[0].floor_z = floor;
    try {
      resolve(part, {}, table());
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const char* said = "POCKET (#30): it lies above the material: z 1 to 6, where the material is z -20 to 0";
  for (const FeatureKind kind : {FeatureKind::kClosedPocket, FeatureKind::kRoundHole, FeatureKind::kSlot})
    EXPECT_THAT(refusal(6, 1, kind), HasSubstr(said));
  EXPECT_THAT(refusal(6, 0, FeatureKind::kClosedPocket), HasSubstr("it lies above the material: z 0 to 6"));
  EXPECT_THAT(refusal(22, 22, FeatureKind::kRoundHole), HasSubstr("its floor is at z 22"));
  EXPECT_EQ(refusal(6, -1, FeatureKind::kClosedPocket), "");
  EXPECT_EQ(refusal(1, 0, FeatureKind::kPlanarFace), "");
}

/// Of a STEP-NC program only that step is left out, and said; a drawing is refused.
TEST(Resolve, StepsOfAProgramAboveTheStockAreLeftOut) {
  Part part = pocket();
  part.stock = Stock{box(part.features[0].target), -20, 0};
  part.features.push_back(part.features[0]);
  part.features[1].name = "GONE";
  part.features[1].top_z = 6;
  part.features[1].floor_z = 1;
  part.workplan[0].source = "#10";
  part.workplan.push_back(part.workplan[0]);
  part.workplan[1].feature = 1;
  part.workplan[1].source = "#20";
  part.workplan[1].name = "second";
  const ResolvedPlan plan = resolve_possible(part, {}, table());
  ASSERT_EQ(plan.part.workplan.size(), 1U);
  EXPECT_EQ(plan.part.workplan[0].source, "#10");
  std::string said;
  for (const Diagnostic& one : plan.part.diagnostics.items()) said += one.what + "\n";
  EXPECT_THAT(said,
              HasSubstr("workingstep #20 'second' is left out: GONE: it lies above the material: z 1 to 6"));
  part.workplan[1].source = "line 4";
  EXPECT_THROW(resolve_possible(part, {}, table()), InputError);
}

/// A drill of nearly the size makes a hole that no other tool makes.
TEST(Resolve, DrillsOfNearlyTheSizeAreTaken) {
  const auto drilled = [](double hole, const std::vector<const char*>& tools, std::string* said = nullptr) {
    Part part = pocket();
    Feature& feature = part.features[0];
    const auto half = [](Vec2 from, Vec2 to) { return Edge::arc(from, to, {5, 5}, Turn::kCounterClockwise); };
    const Vec2 a{5 + hole / 2, 5}, b{5 - hole / 2, 5};
    feature.kind = FeatureKind::kRoundHole;
    feature.hole_diameter = hole;
    feature.target = feature.allowed = {Region::from_valid_loops({half(a, b), half(b, a)}, {})};
    part.tools.clear();
    PlanOptions options;
    for (const char* tool : tools) options.tools.push_back(parse_tool(tool));
    const Part made = resolve(part, options, table()).part;
    for (const Diagnostic& one : made.diagnostics.items())
      if (said && one.severity == Severity::kWarning) *said += one.what;
    return box(made.features[0].target).width();
  };
  std::string said;
  EXPECT_NEAR(drilled(0.991, {"drill:1", "drill:0.8"}, &said), 1, 1e-9);
  EXPECT_THAT(said, HasSubstr("0.991 mm wide, made by the drill of 1 mm: 0.009 mm wider"));
  EXPECT_NEAR(drilled(0.813, {"drill:1", "drill:0.8", "endmill:2"}), 0.8, 1e-9);
  EXPECT_NEAR(drilled(4.21, {"drill:4.2"}), 4.21, 1e-9) << "within what counts as made";
  EXPECT_NEAR(drilled(4.25, {"drill:4.2", "endmill:3"}), 4.25, 1e-9) << "an end mill makes it";
  EXPECT_NEAR(drilled(4.3, {"drill:4.2"}), 4.3, 1e-9) << "too far";
}

}  // namespace
}  // namespace clearcut::resolve
