#include "geometry/route/legal_area.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.h"
#include "base/units.h"

namespace clearcut::inline geometry {
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

TEST(LegalArea, AWayOverACornerIsLegalOnlyIfItIsLegalThere) {
  // The boundary comes up over the way between x = 10 and x = 20, farthest soon after the first.
  const auto over = [](double high) {
    const LegalArea area({outline({{0, -10 * high}, {11, high}, {20, 0}, {20, 10}, {0, 10}})});
    return area.holds_line({0, 0}, {20, 0}) && area.holds_line({20, 0}, {0, 0});
  };
  EXPECT_TRUE(over(0.9 * LegalArea::kSlack));
  EXPECT_FALSE(over(1.6 * LegalArea::kSlack));
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
    const auto same_at = [&](Vec2 p) {
      EXPECT_EQ(area.contains(p), region.contains(p)) << seed;
      const double reach = random.between(0.1, 10);
      EXPECT_EQ(area.is_near_boundary(p, reach), region.boundary_distance(p) <= reach) << seed;
    };
    for (int i = 0; i < 300; ++i) same_at({random.between(-41, 41), random.between(-41, 41)});
    // Level with corners, where rays graze edges.
    for (const Edge& edge : region.edges()) same_at({random.between(-41, 41), edge.from.y});
  }
}

/// The same by every edge of the boundary.
bool holds_plainly(const Region& region, Vec2 p) {
  const auto edges = region.edges();
  return region.contains(p) || std::any_of(edges.begin(), edges.end(), [&](const Edge& edge) {
           return distance(edge, p) <= LegalArea::kSlack;
         });
}

bool holds_plainly(const Region& region, Vec2 a, Vec2 b) {
  const Edge path = Edge::line(a, b);
  std::vector<double> cuts{0, 1};
  const auto add = [&](Vec2 p) { cuts.push_back(dot(p - a, b - a) / norm_squared(b - a)); };
  for (const Edge& edge : region.edges()) {
    for (const Vec2 p : intersections(path, edge)) add(p);
    for (const Vec2 p : {edge.from, edge.to})
      if (distance(path, p) <= LegalArea::kSlack) add(p);
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if ((cuts[i] - cuts[i - 1]) * path.length() < LegalArea::kSlack) continue;
    if (!holds_plainly(region, lerp(a, b, (cuts[i - 1] + cuts[i]) / 2))) return false;
  }
  return true;
}

TEST(LegalArea, HoldsTheWaysThatNoEdgeCrosses) {
  int held = 0, asked = 0;
  for (int seed = 1; seed <= 150; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Region region = Region::from_valid_loops(star(random, {0, 0}, 40, 3 + seed % 40),
                                                   {reversed(star(random, {1, 2}, 8, 3 + seed % 7))});
    const LegalArea area({region});
    const auto edges = region.edges();
    // Anywhere, at a corner, or somewhere on an edge.
    const auto place = [&] {
      const Edge& edge =
          edges[static_cast<std::size_t>(random.between(0, 0.999 * static_cast<double>(edges.size())))];
      const double kind = random.between(0, 3);
      return kind < 1   ? Vec2{random.between(-30, 30), random.between(-30, 30)}
             : kind < 2 ? edge.from
                        : edge.at(random.between(0, 1));
    };
    for (int i = 0; i < 100; ++i) {
      const Vec2 a = place(), b = i % 10 == 0 ? a + direction_of(i) * random.between(0.01, 1) : place();
      if (distance(a, b) <= LegalArea::kSlack) continue;
      const bool expected = holds_plainly(region, a, b);
      EXPECT_EQ(area.holds_line(a, b), expected) << seed << ' ' << i;
      held += expected ? 1 : 0;
      ++asked;
    }
  }
  EXPECT_GT(held, asked / 5);
  EXPECT_LT(held, asked * 4 / 5);
}

/// A board with islands in a frame of two metres: what holds and what does not is the same as by every edge.
TEST(LegalArea, AFrameFarAroundChangesNothing) {
  for (int seed = 1; seed <= 20; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    std::vector<Loop> islands;
    for (int i = 0; i < 36; ++i)
      islands.push_back(
          reversed(star(random, {i % 6 * 5.0, i / 6 * 5.0}, random.between(0.5, 2.4), 3 + i % 9)));
    const std::vector<Vec2> frame{{-1000, -900}, {1100, -900}, {1100, 1000}, {-1000, 1000}};
    const Region region = Region::from_valid_loops(loop_from_points(frame), std::move(islands));
    const LegalArea area({region});
    const auto place = [&](double beyond) {
      return Vec2{random.between(-beyond, 25 + beyond), random.between(-beyond, 25 + beyond)};
    };
    for (int i = 0; i < 200; ++i) {
      const double beyond = i % 4 == 0 ? 1200 : i % 4 == 1 ? 40 : 2;
      const Vec2 a = place(beyond),
                 b = i % 3 == 0 ? a + direction_of(i) * random.between(0.1, 4) : place(beyond);
      EXPECT_EQ(area.contains(a), region.contains(a)) << seed << ' ' << i;
      EXPECT_EQ(area.holds_line(a, b), holds_plainly(region, a, b)) << seed << ' ' << i;
    }
  }
}

/// The cells of a pocket with a small island cover the pocket, not only the island: boxes between both are known to be inside.
TEST(LegalArea, PlacesBesideASmallIslandAreSurelyInside) {
  const std::vector<Vec2> outer{{0, 0}, {94, 0}, {94, 54}, {0, 54}},
      island{{34, 14}, {34, 40}, {60, 40}, {60, 14}};
  const Region region = Region::from_valid_loops(loop_from_points(outer), {loop_from_points(island)});
  const LegalArea area({region});
  for (const Vec2 middle : {Vec2{17, 27}, Vec2{47, 7}, Vec2{77, 27}, Vec2{47, 47}}) {
    EXPECT_TRUE(area.surely_holds(Box{middle, middle}.grown(1))) << middle.x << ' ' << middle.y;
  }
  EXPECT_FALSE(area.surely_holds(Box{{47, 27}, {48, 28}}));
}

}  // namespace
}  // namespace clearcut::inline geometry
