#include "toolpath/legal_area.h"

#include <gtest/gtest.h>

namespace clearcut {
namespace {

Region outline(const std::vector<Vec2>& points) {
  return Region::from_valid_loops(loop_from_points(points), {});
}

TEST(LegalArea, AWayAlongTheBoundaryIsLegalAsFarAsTheBoundaryGoes) {
  const LegalArea area({outline({{0, 0}, {20, 0}, {20, 10}, {0, 10}})});
  EXPECT_TRUE(area.holds_line({2, 0}, {18, 0}));
  EXPECT_TRUE(area.holds_line({0, 0}, {20, 0}));
  EXPECT_FALSE(area.holds_line({-8, 0}, {18, 0}));
  EXPECT_FALSE(area.holds_line({2, 10}, {21, 10}));
}

TEST(LegalArea, AWayAlongTwoBoundariesIsNotLegalBetweenThem) {
  const LegalArea area(
      {outline({{0, 0}, {20, 0}, {20, 10}, {0, 10}}), outline({{30, 0}, {60, 0}, {60, 10}, {30, 10}})});
  EXPECT_FALSE(area.holds_line({2, 0}, {58, 0}));
  EXPECT_FALSE(area.holds_line({58, 10}, {2, 10}));
}

}  // namespace
}  // namespace clearcut
