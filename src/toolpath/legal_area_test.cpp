#include "toolpath/legal_area.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "base/units.h"

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

/// A star about a place, of lines and arcs.
Loop star(Random& random, Vec2 center, double size, int corners) {
  std::vector<BulgeVertex> vertices;
  for (int i = 0; i < corners; ++i) {
    const double bulge = random.between(0, 1) < 0.5 ? random.between(-0.1, 0.1) : 0;
    vertices.push_back(
        {center + direction_of(2 * kPi * i / corners) * (size * random.between(0.6, 1)), bulge});
  }
  return loop_from_bulges(vertices);
}

TEST(LegalArea, ContainsWhatItsRegionsContain) {
  for (int seed = 1; seed <= 200; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Region region = Region::from_valid_loops(star(random, {0, 0}, 40, 3 + seed % 60),
                                                   {reversed(star(random, {1, 2}, 8, 3 + seed % 7))});
    const LegalArea area({region});
    const auto same_at = [&](Vec2 p) { EXPECT_EQ(area.contains(p), region.contains(p)) << seed; };
    for (int i = 0; i < 300; ++i) same_at({random.between(-41, 41), random.between(-41, 41)});
    // Level with corners, where rays graze edges.
    for (const Edge& edge : region.edges()) same_at({random.between(-41, 41), edge.from.y});
  }
}

}  // namespace
}  // namespace clearcut
