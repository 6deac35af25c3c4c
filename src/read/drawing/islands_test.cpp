#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "geometry/contours/boolean.h"
#include "read/job/read_part.h"

namespace clearcut::read {
namespace {

using ::testing::HasSubstr;

std::string circle(const std::string& layer, double x, double y, double radius) {
  return " 0 CIRCLE 8 " + layer + " 10 " + std::to_string(x) + " 20 " + std::to_string(y) + " 40 " +
         std::to_string(radius);
}

/// A pocket of 60 x 40 mm with a boss of 10 mm radius in its middle.
Part with_boss(const std::string& more) {
  std::string text =
      "0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 ENTITIES 0 LWPOLYLINE 8 POCKET_D5 90 4 70 1 "
      "10 0 20 0 10 60 20 0 10 60 20 40 10 0 20 40" +
      circle("ISLAND", 30, 20, 10) + more + " 0 ENDSEC 0 EOF ";
  for (char& c : text)
    if (c == ' ') c = '\n';
  return read_part_text(text, "boss.dxf", {});
}

double area_of(const Part& part, const std::string& name) {
  for (const Feature& feature : part.features)
    if (feature.name == name) return area(feature.target);
  return 0;
}

constexpr double kDisc = 3.14159265358979;  ///< mm2, of 1 mm radius

TEST(Islands, HoldWhatIsDrawnInThem) {
  for (const char* layer : {"DRILL_D8", "TAP_M6_D8", "POCKET_D2", "VCARVE_D1", "ENGRAVE_D1", "INSIDE_D2"}) {
    const Part part = with_boss(circle(layer, 30, 20, 3));
    ASSERT_EQ(part.features.size(), 2u) << layer;
    EXPECT_NEAR(area_of(part, "POCKET_D5"), 2400 - 100 * kDisc, 0.01) << layer;
  }
  EXPECT_NEAR(area_of(with_boss(circle("POCKET_D2", 30, 20, 3)), "POCKET_D2"), 9 * kDisc, 0.01);
}

TEST(Islands, AreLeftByWhatReachesOverTheirEdge) {
  const Part part = with_boss(circle("A_POCKET_D3", 40, 20, 4));
  ASSERT_EQ(part.features.size(), 2u);
  EXPECT_LT(area_of(part, "A_POCKET_D3"), 16 * kDisc - 5);
  EXPECT_GT(area_of(part, "A_POCKET_D3"), 5);
}

TEST(Islands, StayWhereAnotherOutlineIsTheSame) {
  const Part part = with_boss(circle("B_POCKET_D2", 30, 20, 10));
  EXPECT_EQ(part.features.size(), 1u);
  ASSERT_FALSE(part.diagnostics.items().empty());
  EXPECT_THAT(part.diagnostics.items().back().what, HasSubstr("is that of an island, which stays"));
}

}  // namespace
}  // namespace clearcut::read
