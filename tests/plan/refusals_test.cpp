// What no plan can help is refused with an answer that does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "geometry/region.h"
#include "resolve/resolve.h"
#include "resolve/unreached.h"

namespace clearcut::resolve {
namespace {

using ::testing::HasSubstr;

Feature pocket(const Box& box, double top, double floor) {
  Feature feature;
  feature.name = "POCKET" + std::to_string(static_cast<int>(-floor));
  feature.target = feature.allowed = {rectangular_region(box)};
  feature.top_z = top;
  feature.floor_z = floor;
  return feature;
}

/// A pocket of 110 mm with one of 20 mm in its floor, cut with one end mill of 10 mm.
Part two_levels(std::optional<double> flutes) {
  Part part;
  part.features = {pocket({{0, 0}, {80, 60}}, 0, -110), pocket({{20, 20}, {60, 40}}, -110, -130)};
  part.stock = Stock{{{-10, -10}, {90, 70}}, -150, 0};
  Tool tool;
  tool.diameter = 10;
  tool.flute_length = flutes;
  part.tools = {tool};
  part.workplan.resize(2);
  part.workplan[1].feature = 1;
  return part;
}

std::string refusal(const Part& part) {
  try {
    refuse_what_cannot_be(part, {});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// What is left out because the flutes of its tool do not reach it, and why; "" if the part is refused or all is made.
std::string left_out(const Part& part) {
  std::string text;
  if (!refusal(part).empty()) return text;
  const std::vector<std::string> unreached = unreached_steps(part, {});
  for (std::size_t i = 0; i < unreached.size(); ++i)
    if (!unreached[i].empty()) text += feature_of(part, part.workplan[i]).name + ": " + unreached[i] + "\n";
  return text;
}

TEST(Refusals, LengthsOfFlutesThatAreProposedAreTaken) {
  EXPECT_THAT(refusal(two_levels(std::nullopt)), HasSubstr("POCKET110: it is 110 mm deep"));
  EXPECT_THAT(refusal(two_levels(std::nullopt)), HasSubstr("endmill:10:length=110,"));
  EXPECT_EQ(refusal(two_levels(110)), "");
  EXPECT_EQ(left_out(two_levels(110)), "") << "nothing stands beside the cutter over the lower pocket";
}

TEST(Refusals, FlutesReachUpToTheTopOfWhatStandsBesideTheTool) {
  EXPECT_THAT(refusal(two_levels(109)),
              HasSubstr("POCKET110: its floor lies 110 mm below the top of the material around it"));
  Part part = two_levels(110);
  part.features[1].target = part.features[1].allowed = {rectangular_region({{0, 20}, {60, 40}})};
  EXPECT_THAT(left_out(part), HasSubstr("POCKET130: its floor lies 130 mm below"))
      << "under a wall of the upper one";
  part = two_levels(110);
  std::swap(part.workplan[0], part.workplan[1]);
  EXPECT_THAT(left_out(part), HasSubstr("POCKET130: its floor lies 130 mm below"))
      << "the upper one is cut later";
  part = two_levels(110);
  part.tools[0].shank_diameter = 60;
  EXPECT_THAT(left_out(part), HasSubstr("POCKET130: its floor lies 130 mm below")) << "its shank is wide";
}

/// A deep pocket beside a shallow one is left out; alone, or with work that rests on it, it is refused.
TEST(Refusals, WhatLiesBeyondTheFlutesIsLeftOutWhereMoreIsToBeDone) {
  Part part;
  part.features = {pocket({{0, 0}, {20, 20}}, 0, -5), pocket({{30, 0}, {50, 20}}, 0, -60)};
  part.stock = Stock{{{-10, -10}, {60, 30}}, -80, 0};
  Tool tool;
  tool.diameter = 5;
  part.tools = {tool};
  part.workplan.resize(2);
  part.workplan[1].feature = 1;
  EXPECT_THAT(left_out(part), HasSubstr("POCKET60: it is 60 mm deep, 12 diameters"));
  Part rested = part;
  rested.features[0] = pocket({{35, 5}, {45, 15}}, -60, -65);
  EXPECT_THAT(refusal(rested), HasSubstr("POCKET60: it is 60 mm deep")) << "the other begins at its floor";
  rested.features[0] = pocket({{10, 0}, {30, 20}}, 0, -5);
  EXPECT_THAT(refusal(rested), HasSubstr("POCKET60: it is 60 mm deep")) << "no wall stands between";
  Part rests = part;
  rests.workplan.push_back(rests.workplan[1]);
  EXPECT_NE(left_out(rests), "") << "none of its steps reaches down";
  rests.tools.push_back(tool);
  rests.tools[1].diameter = 10;
  rests.workplan[1].operation.tool = 1;
  EXPECT_THAT(refusal(rests), HasSubstr("POCKET60: it is 60 mm deep")) << "one of its steps makes it";
  part.workplan.erase(part.workplan.begin());
  EXPECT_THAT(refusal(part), HasSubstr("POCKET60: it is 60 mm deep")) << "nothing else is made";
}

TEST(Refusals, CuttersThatMayNotPlungeNeedRoomToGoDown) {
  Part part;
  part.features = {pocket({{0, 0}, {4.1, 4.1}}, 0, -3)};
  part.workplan.resize(1);
  Tool tool;
  tool.diameter = 4;
  tool.center_cutting = false;
  part.tools = {tool};
  EXPECT_THAT(refusal(part), HasSubstr("may not plunge and has no room for a ramp"));
  part.predrilled = {{{2, 2}, 4.1}};
  EXPECT_EQ(refusal(part), "");
  part.predrilled.clear();
  part.features = {pocket({{0, 0}, {4, 8}}, 0, -3)};
  EXPECT_EQ(refusal(part), "") << "it ramps along the slot";
  part.features = {pocket({{0, 0}, {4.1, 4.1}}, 0, -3)};
  part.tools[0].center_cutting = true;
  EXPECT_EQ(refusal(part), "");
}

}  // namespace
}  // namespace clearcut::resolve
