// Published methods leave material; rapids of ours never go through it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

/// A deep pocket near the wall of a shallow one, where methods that leave rims and corners leave them in its way.
std::string stacked() {
  return outline("POCKET_D4", {{{0, 0}}, {{57, 0}}, {{57, 43}}, {{20, 43}}, {{0, 30}}}) +
         box("POCKET_D9", 42, 28, 56, 42);
}

PlanResult planned(const char* strategy, const char* stepover, bool is_published) {
  PlanOptions options = with({"endmill:10"});
  options.strategy = strategy;
  if (*stepover != '\0') options.stepover = stepover;
  if (is_published) options.published.published_grid = true;
  return plan_part(drawn(stacked()), options);
}

TEST(RapidsOverRests, OfThePublishedGridMeetNothing) {
  const PlanResult result = planned("tour", "", true);
  EXPECT_GT(result.findings.all.uncut_mm2, 1);
  EXPECT_EQ(result.findings.all.rapid_in_material, 0) << faults_of(result.findings);
}

TEST(RapidsOverRests, OfPublishedContoursMeetNothing) {
  for (const char* strategy : {"lom", "second", "fixed", "bisectors"}) {
    for (const char* stepover : {"", "0.99"}) {
      const PlanResult result = planned(strategy, stepover, false);
      EXPECT_EQ(result.findings.all.rapid_in_material, 0) << strategy << " " << stepover << "\n"
                                                          << faults_of(result.findings);
    }
  }
}

TEST(RapidsOverRests, WhatHoldsNoPointOfThePublishedGridIsNamed) {
  PlanOptions options = with({"endmill:10"});
  options.strategy = "tour";
  options.published.published_grid = true;
  const std::string narrow = box("POCKET_D4", 0, 0, 57, 43) + circle("A_HOLE_D8", {80, 20}, 7);
  options.stepover = "0.5";
  const PlanResult result = plan_part(drawn(narrow), options);
  EXPECT_THAT(result.program, HasSubstr("NOT MACHINED: A_HOLE_D8"));
  ASSERT_FALSE(result.findings.faults.empty());
  EXPECT_EQ(result.findings.faults.front().kind, FaultKind::kNothingCut);
  EXPECT_THAT(result.findings.faults.front().text, HasSubstr("no point of the published grid"));
}

}  // namespace
}  // namespace clearcut::pipeline
