// What no plan can help is refused with an answer that does.
#include "resolve/refusals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "geometry/rectangle.h"

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

TEST(Refusals, LengthsOfFlutesThatAreProposedAreTakenAndReachTheDeepestFloor) {
  EXPECT_THAT(refusal(two_levels(std::nullopt)), HasSubstr("POCKET110: it is 110 mm deep"));
  EXPECT_THAT(refusal(two_levels(std::nullopt)), HasSubstr("endmill:10:length=130,"));
  EXPECT_THAT(refusal(two_levels(110)),
              HasSubstr("POCKET130: its floor lies 130 mm below the top of the part"));
  EXPECT_EQ(refusal(two_levels(130)), "");
}

}  // namespace
}  // namespace clearcut::resolve
