// Pieces that come free: programs that still cut in them are wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

const char* const kOperation = "(OPERATION";

/// A program with the operation of this name before all others; each begins and ends high above the part.
std::string with_first(const std::string& program, const std::string& name) {
  const std::size_t begin = program.find(kOperation), end = program.rfind("M5");
  std::vector<std::string> blocks;
  for (std::size_t at = begin; at < end;) {
    const std::size_t next = std::min(program.find(kOperation, at + 1), end);
    blocks.push_back(program.substr(at, next - at));
    at = next;
  }
  // The first of all holds the tool change as well, which stays where it is.
  const std::size_t start = program.find("G0 ", begin) + 3;
  std::string head = program.substr(0, start - 3);
  blocks.front() = blocks.front().substr(start - begin);
  std::string rest;
  for (const std::string& block : blocks) {
    const bool is_asked = block.find(": " + name + ")") != std::string::npos;
    (is_asked ? head : rest) +=
        "G0 Z10\n" + block.substr(block.find(kOperation) == 0 ? block.find('\n') + 1 : 0);
  }
  return head + rest + program.substr(end);
}

/// A plate of 80 x 50 mm with a pocket and two holes.
std::string plate() {
  return box("PROFILE_D6", 0, 0, 80, 50) + box("POCKET_D3", 20, 15, 60, 35) + circle("INSIDE_D6", {8, 8}, 4) +
         circle("INSIDE_D6", {72, 42}, 4);
}

PlanOptions asked(int tabs = 0) {
  auto options = with({"endmill:4"});
  options.strategy = "contour";
  options.tabs.count = tabs;
  return options;
}

TEST(LooseParts, ACutOutBeforeItsHolesIsFaulty) {
  const Part part = drawn(plate());
  const auto right = plan_part(part, asked());
  EXPECT_EQ(faults_of(right.findings), "");
  const std::string wrong = with_first(right.program, "PROFILE_D6");
  const auto found = check_program(part, wrong, "wrong.ngc", asked()).findings;
  ASSERT_EQ(found.faults.size(), 1u) << faults_of(found);
  EXPECT_EQ(found.faults[0].kind, FaultKind::kLoosePart);
  EXPECT_THAT(found.faults[0].text, HasSubstr("Cuts in the part that PROFILE_D6 has cut free"));
  EXPECT_GT(found.faults[0].at.line, 0);
  EXPECT_EQ(verdict_of(found), Verdict::kFaulty);
}

TEST(LooseParts, WhatIsHeldMayBeCut) {
  const Part part = drawn(plate());
  // Tabs and skins hold it; so does a stock that is thicker than the profile is deep.
  auto tabs = asked(4), skin = asked();
  tabs.tabs.shape = TabShape::kTriangular;
  skin.tabs.skin = 0.4;
  const std::string last[] = {"PROFILE_D6_TABS", "PROFILE_D6"};
  const PlanOptions held[] = {tabs, skin};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string program = plan_part(part, held[i]).program;
    const auto found = check_program(part, with_first(program, last[i]), "early.ngc", held[i]).findings;
    EXPECT_THAT(faults_of(found), ::testing::Not(HasSubstr("loose part")));
  }
  Part thick = part;
  thick.stock = Stock{{{-10, -10}, {90, 60}}, -10, 0};
  const std::string program = plan_part(thick, asked()).program;
  EXPECT_EQ(faults_of(check_program(thick, with_first(program, "PROFILE_D6"), "thick.ngc", asked()).findings),
            "");
}

/// A line that is followed frees what it surrounds as a profile does, once it goes through the stock.
TEST(LooseParts, LinesThroughTheStockFreeWhatTheySurround) {
  const std::string stock = box("STOCK_D6", -10, -10, 90, 60);
  const Part part = drawn(stock + box("ON_D6", 0, 0, 80, 50) + box("POCKET_D3", 20, 15, 60, 35) +
                          circle("INSIDE_D6", {8, 8}, 4) + circle("ON_D6", {72, 42}, 4) +
                          circle("ENGRAVE_D1", {40, 25}, 5));
  const auto right = plan_part(part, asked());
  EXPECT_EQ(faults_of(right.findings), "");
  std::string outer;
  for (const Feature& feature : right.part.features)
    if (feature.profile && box(feature.profile->line).width() > 70) outer = feature.name;
  const auto& last =
      right.part.workplan[static_cast<std::size_t>(right.toolpath.sections.back().workingstep)];
  EXPECT_EQ(feature_of(right.part, last).name, outer);
  const auto faults = [&](const Part& of, const std::string& program) {
    return faults_of(check_program(of, with_first(program, outer), "wrong.ngc", asked()).findings);
  };
  EXPECT_THAT(faults(part, right.program), HasSubstr("Cuts in the piece that " + outer + " has cut free"));
  // Neither an open line nor one that ends within the material frees anything.
  Part thick = part;
  thick.stock->z_bottom = -8;
  EXPECT_THAT(faults(thick, plan_part(thick, asked()).program), ::testing::Not(HasSubstr("loose part")));
  auto held = asked(3);
  held.tabs.width = 2;
  const std::string program = plan_part(part, held).program;
  EXPECT_THAT(
      faults_of(check_program(part, with_first(program, outer + "_TABS"), "early.ngc", held).findings),
      ::testing::Not(HasSubstr("loose part")));
}

/// All of a part is finished before the cut-out goes through, also where the two run into each other; a cut-out within it, too.
TEST(LooseParts, FinishingComesBeforeWhatFreesThePart) {
  const std::string edge = box("PROFILE_D6", 0, 0, 80, 50), window = circle("INSIDE_D6", {14, 14}, 7);
  for (const std::string& pocket : {box("POCKET_D3", 30, 15, 60, 35), box("POCKET_D3", 30, 35, 60, 58)}) {
    for (const char* finish : {"walls", "all"}) {
      auto options = asked();
      options.shop.finish = finish;
      EXPECT_EQ(faults_of(plan_part(drawn(edge + window + pocket), options).findings), "") << finish;
    }
  }
}

TEST(LooseParts, WorkBesideAPieceIsNone) {
  // The holes' waste comes free first; of two parts one does before the other is begun.
  const Part part = drawn(plate() + box("PROFILE_D6", 100, 0, 140, 50) + circle("INSIDE_D6", {120, 25}, 6));
  const std::string program = plan_part(part, asked()).program;
  for (const char* name : {"INSIDE_D6", "INSIDE_D6_2"}) {
    const auto found = check_program(part, with_first(program, name), "early.ngc", asked()).findings;
    EXPECT_EQ(faults_of(found), "") << name;
  }
}

TEST(LooseParts, APartInTheWasteOfAnotherIsCutBeforeThat) {
  const Part part = drawn(box("PROFILE_D6", 0, 0, 80, 80) + box("PROFILE_D6", 10, 10, 70, 70) +
                          box("PROFILE_D6", 25, 25, 55, 55));
  const auto right = plan_part(part, asked());
  EXPECT_EQ(faults_of(right.findings), "");
  std::string window;
  for (const Feature& feature : right.part.features)
    if (feature.kind == FeatureKind::kInsideProfile) window = feature.name;
  const auto found = check_program(part, with_first(right.program, window), "wrong.ngc", asked()).findings;
  EXPECT_THAT(faults_of(found), HasSubstr("loose part: "));
  EXPECT_THAT(faults_of(found), HasSubstr("Cuts in the piece that " + window + " has cut free"));
}

}  // namespace
}  // namespace clearcut::pipeline
