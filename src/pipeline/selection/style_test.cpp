// What is chosen where nobody says how: as a machinist would in metal, else the fastest.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/test_drawings.h"
#include "pipeline/texts.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

const std::string kPocket = box("STOCK_D12", -10, -10, 90, 60) + rounded_box("POCKET_D6", 0, 0, 80, 50, 8);

PlanOptions asked(const char* material, const char* style) {
  PlanOptions options = with({"endmill:8"});
  if (*material) options.shop.material = material;
  if (*style) options.shop.style = style;
  return options;
}

std::string value_of(const PlanResult& result, const std::string& name) {
  for (const ResolvedValue& value : result.values)
    if (value.name == name) return value.value + " (" + value.source.text + ")";
  return "";
}

/// Of the cutting length.
double climb_share(const PlanResult& result) {
  const Engagement& all = result.findings.all.engagement;
  return all.climb_mm / (all.climb_mm + all.conventional_mm);
}

TEST(Style, InMetalItIsTheMachinists) {
  const PlanResult result = plan_part(drawn(kPocket), asked("aluminium", ""));
  EXPECT_TRUE(result.findings.all.clean) << faults_of(result.findings);
  EXPECT_EQ(value_of(result, "style"), "machinist (default: machinist: the work is a metal)");
  EXPECT_EQ(value_of(result, "entry"), "helix (the style machinist)");
  EXPECT_EQ(value_of(result, "stepover"), "0.45 (the style machinist)");
  EXPECT_LT(result.findings.all.engagement.max_deg, 90);
  EXPECT_GT(climb_share(result), 0.9);
}

TEST(Style, TheFastestIsHadByAskingAndWithoutAMetal) {
  const Part part = drawn(kPocket);
  const PlanResult machinist = plan_part(part, asked("aluminium", ""));
  const PlanResult fastest = plan_part(part, asked("aluminium", "fastest"));
  EXPECT_TRUE(fastest.findings.all.clean);
  EXPECT_LT(fastest.findings.all.time_s, machinist.findings.all.time_s);
  EXPECT_GT(fastest.findings.all.engagement.max_deg, 150);
  EXPECT_THAT(value_of(plan_part(part, asked("mdf", "")), "style"), HasSubstr("fastest"));
  EXPECT_EQ(plan_part(part, asked("", "")).program, plan_part(part, asked("", "fastest")).program);
  EXPECT_EQ(value_of(plan_part(part, asked("", "machinist")), "stepover"), "0.45 (the style machinist)");
}

TEST(Style, WhatIsStatedGoesBeforeIt) {
  const Part part = drawn(kPocket);
  PlanOptions options = asked("steel", "");
  options.entry = EntryKind::kRamp;
  options.stepover = "0.3";
  const PlanResult stated = plan_part(part, options);
  EXPECT_TRUE(stated.findings.all.clean) << faults_of(stated.findings);
  EXPECT_THAT(value_of(stated, "entry"), HasSubstr("ramp"));
  EXPECT_THAT(value_of(stated, "stepover"), HasSubstr("0.3"));
  options = asked("steel", "");
  options.strategy = "zigzag";
  EXPECT_THAT(value_of(plan_part(part, options), "stepover"), HasSubstr("by strategy"));
}

/// A slot as wide as the cutter has full-width cuts whatever is chosen: that is no fault.
TEST(Style, ASlotThatTheCutterJustFitsIsCut) {
  const std::string slot =
      box("STOCK_D12", -10, -10, 90, 30) + rounded_box("SLOT POCKET_D4", 0, 0, 60, 8.02, 4);
  const PlanResult result = plan_part(drawn(slot), asked("steel", ""));
  EXPECT_TRUE(result.findings.all.clean) << faults_of(result.findings);
  EXPECT_GT(result.findings.all.feed_mm, 50);
}

/// How often the plan's diagnostics name the other style.
int times_told(const Part& part, const PlanOptions& options) {
  int count = 0;
  const PlanResult result = plan_part(part, options);
  for (const Diagnostic& said : result.part.diagnostics.items())
    count += said.what.find("--style machinist") != std::string::npos;
  return count;
}

/// Nobody asked for plunges and full width: that they are chosen is said, and how to have what a machinist would do.
TEST(Style, ThatItIsTheFastestIsSaidWhereNobodyChose) {
  const Part part = drawn(kPocket);
  EXPECT_EQ(times_told(part, asked("", "")), 1);
  EXPECT_EQ(times_told(part, asked("", "fastest")), 0);
  EXPECT_EQ(times_told(part, asked("mdf", "")), 0);
  EXPECT_EQ(times_told(part, asked("steel", "")), 0);
  PlanOptions ramped = asked("", "");
  ramped.entry = EntryKind::kRamp;
  EXPECT_EQ(times_told(part, ramped), 0);
}

TEST(Style, OneThatIsNoneIsRefused) {
  EXPECT_THROW(resolve::check(asked("", "sloppy")), InputError);
}

double feed_of(const FeatureFindings& step) {
  return step.figures.feed_mm;
}

/// Along a wall, a cutter would take the stock of both walls of a corner at once: 116 degrees and more. Corners are cut by arcs.
TEST(LimitedEngagement, HoldsInTheCornersOfFinishedWalls) {
  for (const double limit : {60.0, 90.0, 110.0}) {
    PlanOptions options = with({"endmill:4"});
    options.engagement_deg = limit;
    options.shop.finish = "walls";
    const PlanResult result = plan_part(drawn(box("POCKET_D2", 0, 0, 20, 20)), options);
    ASSERT_EQ(result.findings.features.size(), 2U);
    EXPECT_TRUE(result.findings.all.clean) << limit;
    EXPECT_LE(result.findings.all.engagement.max_deg, limit + 2);
    // A pass along the walls has 64 mm.
    EXPECT_LT(feed_of(result.findings.features.back()), 140) << limit;
  }
}

/// The small mill comes from what the wide one has cleared, and cuts four corners, not the boxes around them.
TEST(LimitedEngagement, RestsAreCutFromWhatIsCleared) {
  PlanOptions options = with({"endmill:6", "endmill:2"});
  options.engagement_deg = 60;
  options.shop.rest = true;
  const PlanResult result = plan_part(drawn(box("POCKET_D4", 0, 0, 40, 30)), options);
  ASSERT_EQ(result.findings.features.size(), 2U);
  EXPECT_TRUE(result.findings.all.clean);
  EXPECT_LT(feed_of(result.findings.features.back()), 400);
}

}  // namespace
}  // namespace clearcut::pipeline
