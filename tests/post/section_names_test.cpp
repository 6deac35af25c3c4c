// What programs call their operations, and that reading them back finds each again.
#include "model/section_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

using ::testing::Contains;

/// Pockets far apart, of which the first is not the nearest to where the work begins; two mills on each.
PlanResult planned(const PlanOptions& options) {
  return plan_part(drawn(box("POCKET_D4", 0, 0, 40, 30) + box("POCKET_D5", 300, 0, 340, 30) +
                         box("POCKET_D6", 60, 0, 100, 30) + circle("DRILL_D4", {200, 15}, 2.5)),
                   options);
}

PlanOptions two_mills() {
  auto options = with({"endmill:6", "endmill:3", "drill:5"});
  options.shop.rest = true;
  return options;
}

TEST(SectionNames, ProgramsCountTheirOperationsAndSayWhatEachDoes) {
  const std::string program = planned(two_mills()).program;
  const std::regex comment(R"(\(OPERATION (\d+): ([^)]*)\))");
  std::vector<std::string> labels;
  for (std::sregex_iterator it(program.begin(), program.end(), comment), end; it != end; ++it) {
    labels.push_back((*it)[2]);
    EXPECT_EQ(std::stoul((*it)[1]), labels.size()) << "in the order of cutting";
  }
  EXPECT_EQ(labels.size(), 7U);
  for (const char* label : {"POCKET_D4 ROUGH", "POCKET_D4 REST", "POCKET_D6 REST", "DRILL_D4"})
    EXPECT_THAT(labels, Contains(label));
}

TEST(SectionNames, WhatIsReadBackBelongsToItsOwnStep) {
  const auto options = two_mills();
  const PlanResult result = planned(options);
  const SectionNames names(result.part);
  for (const Section& section : result.toolpath.sections) {
    const Workingstep& step = result.part.workplan.at(static_cast<std::size_t>(section.workingstep));
    EXPECT_EQ(tool_of(result.part, step).number, section.tool_number) << section.label;
  }
  Section unknown;
  unknown.label = "ANYTHING ELSE";
  unknown.workingstep = 2;
  EXPECT_EQ(names.workingstep_of(unknown), 2) << "a number goes where no name does";
  unknown.workingstep = 99;
  EXPECT_EQ(names.workingstep_of(unknown), -1);
  unknown.label = "pocket_d5";
  EXPECT_EQ(names.of(names.workingstep_of(unknown)), "POCKET_D5 rough") << "by its feature the first step";
}

}  // namespace
}  // namespace clearcut::pipeline
