#include "geometry/contours/boolean.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "base/units.h"

namespace clearcut::inline geometry {
namespace {

const Tolerances kTol;

Loop rectangle(Vec2 min, Vec2 max) {
  return loop_from_points(std::vector<Vec2>{min, {max.x, min.y}, max, {min.x, max.y}});
}

Loop circle(Vec2 center, double radius) {
  const Vec2 right = center + Vec2{radius, 0}, left = center - Vec2{radius, 0};
  return {Edge::arc(right, left, center, Turn::kCounterClockwise),
          Edge::arc(left, right, center, Turn::kCounterClockwise)};
}

Regions one(Loop outer, std::vector<Loop> islands = {}) {
  return {Region::from_valid_loops(std::move(outer), std::move(islands))};
}

int arcs(const Regions& regions) {
  int count = 0;
  for (const auto& region : regions) {
    for (const auto& edge : region.edges()) count += edge.is_arc() ? 1 : 0;
  }
  return count;
}

void expect_joined(const Loop& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i) EXPECT_EQ(loop[i].to, loop[(i + 1) % loop.size()].from);
}

Loop capsule(Vec2 a, Vec2 b, double radius) {
  const Vec2 across = left_of((b - a) / distance(a, b)) * radius;
  return {Edge::line(a - across, b - across), Edge::arc(b - across, b + across, b, Turn::kCounterClockwise),
          Edge::line(b + across, a + across), Edge::arc(a + across, a - across, a, Turn::kCounterClockwise)};
}

/// Of every round end a piece shows that is shorter than the chords it is clipped as: its arc is looked for among all.
TEST(Boolean, BandsSideBySideAreUnitedInAFewSteps) {
  constexpr int kBands = 3000;
  constexpr double kPitch = 0.005, kRadius = 0.05, kLength = 3;  // mm
  std::vector<Loop> bands;
  for (int i = 0; i < kBands; ++i) bands.push_back(capsule({i * kPitch, 0}, {i * kPitch, kLength}, kRadius));
  const Regions united = unite_loops(bands, kTol);
  ASSERT_EQ(united.size(), 1u);
  // All ends but the outermost stand out by the radius, less the bow between two of them.
  const double bow = kPitch * kPitch / (24 * kRadius);
  const double all = (kBands - 1) * kPitch * (kLength + 2 * (kRadius - bow)) + 2 * kRadius * kLength +
                     kPi * kRadius * kRadius;
  EXPECT_NEAR(area(united), all, 1e-4);
  EXPECT_NEAR(area(resolve_nonzero(bands, kTol)), all, 1e-4);
}

/// Rings in rings beside each other, and rings that touch from inside and outside.
TEST(Boolean, ContoursAreNestedToAnyDepth) {
  std::vector<Loop> loops;
  for (int column = 0; column < 20; ++column)
    for (int depth = 0; depth < 9; ++depth)
      loops.push_back(
          rectangle({column * 20.0 + depth, 1.0 * depth}, {column * 20.0 + 20 - depth, 20.0 - depth}));
  const Regions regions = resolve_even_odd(loops, kTol);
  // The outermost squares share walls, and are one region.
  EXPECT_EQ(regions.size(), 1U + 20 * 4);
  double all = 0;
  for (int depth = 0; depth < 9; ++depth)
    all += (depth % 2 == 0 ? 1 : -1) * (20.0 - 2 * depth) * (20.0 - 2 * depth);
  EXPECT_NEAR(area(regions), 20 * all, 1e-6);
  const Loop hole = rectangle({5, 0}, {10, 5}), within = rectangle({6, 1}, {10, 4});
  const Regions touching = resolve_even_odd(std::vector{rectangle({0, 0}, {20, 20}), hole, within}, kTol);
  EXPECT_NEAR(area(touching), 400 - 25 + 12, 1e-6);
}

/// A tilted rectangle in the notch of a larger outline, along whose edge every place of its own rounds to within the outline.
TEST(Boolean, WhatSharesATiltedEdgeLiesBesideIt) {
  const Vec2 notched[] = {{-31.544187, 43.175228}, {-57.272854, 123.710164}, {-89.486829, 113.418697},
                          {-79.195362, 81.204723}, {-74.049628, 65.097735},  {-106.263603, 54.806269},
                          {-95.972136, 22.592294}};
  const Vec2 beside[] = {
      {-79.195362, 81.204723}, {-89.486829, 113.418697}, {-105.593816, 108.272963}, {-95.302349, 76.058989}};
  const std::vector<Loop> loops{loop_from_points(notched), loop_from_points(beside)};
  const Regions regions = resolve_even_odd(loops, kTol);
  for (const Region& region : regions) EXPECT_TRUE(region.islands().empty());
  EXPECT_NEAR(area(regions), signed_area(loops[0]) + signed_area(loops[1]), 1e-3);
}

TEST(Boolean, UnionOfOverlappingSquaresHasTheirOutline) {
  const auto result = unite(one(rectangle({0, 0}, {10, 10})), one(rectangle({5, 5}, {15, 15})), kTol);
  ASSERT_EQ(result.size(), 1u);
  EXPECT_EQ(result[0].outer().size(), 8u);
  EXPECT_NEAR(area(result), 175, 1e-9);
}

TEST(Boolean, HoleAndIslandInItAreNested) {
  const auto ring = subtract(one(rectangle({0, 0}, {30, 30})), one(rectangle({5, 5}, {25, 25})), kTol);
  ASSERT_EQ(ring.size(), 1u);
  EXPECT_EQ(ring[0].islands().size(), 1u);
  const auto both = unite(ring, one(rectangle({10, 10}, {20, 20})), kTol);
  EXPECT_EQ(both.size(), 2u);
  EXPECT_NEAR(area(both), 900 - 400 + 100, 1e-9);
}

TEST(Boolean, ArcsStayArcsOnTheirCircle) {
  const auto result = subtract(one(rectangle({0, 0}, {20, 20})), one(circle({20, 10}, 5)), kTol);
  ASSERT_EQ(result.size(), 1u);
  EXPECT_NEAR(area(result), 400 - kPi * 25 / 2, 1e-6);
  EXPECT_LE(arcs(result), 2);
  for (const auto& edge : result[0].outer()) {
    if (!edge.is_arc()) continue;
    EXPECT_EQ(edge.center, (Vec2{20, 10}));
    EXPECT_EQ(edge.turn, Turn::kClockwise);
    EXPECT_NEAR(distance(edge.from, edge.center), 5, 1e-9);
  }
  expect_joined(result[0].outer());
}

TEST(Boolean, SharedArcWallVanishesWithoutSlivers) {
  const auto disc = one(circle({0, 0}, 10));
  EXPECT_TRUE(subtract(disc, disc, kTol).empty());
  const auto same = unite(disc, disc, kTol);
  ASSERT_EQ(same.size(), 1u);
  EXPECT_NEAR(area(same), kPi * 100, 1e-9);
  EXPECT_EQ(same[0].outer().size(), 2u);
}

TEST(Boolean, ArcsThatRunAlongEachOtherBecomeOne) {
  // The same circle on both, begun at different places: flattened, the two alternate in the outline.
  const Regions part = intersect(one(circle({3, 2}, 13.6)), one(rectangle({0, -20}, {30, 20})), kTol);
  const auto result =
      unite(part, intersect(one(circle({3, 2}, 13.6)), one(rectangle({-20, -3.3}, {30, 4.7})), kTol), kTol);
  ASSERT_EQ(result.size(), 1u);
  expect_joined(result[0].outer());
  EXPECT_LE(result[0].outer().size(), 12u);
}

TEST(Boolean, CrossingOutlineIsResolvedEvenOdd) {
  const std::vector<Loop> bow_tie{loop_from_points(std::vector<Vec2>{{0, 0}, {10, 10}, {10, 0}, {0, 10}})};
  const auto result = resolve_even_odd(bow_tie, kTol);
  EXPECT_EQ(result.size(), 2u);
  EXPECT_NEAR(area(result), 50, 1e-6);
}

TEST(Boolean, LoopsWithoutAreaGiveNothing) {
  const std::vector<Vec2> spike{{0, 0}, {10, 0}, {20, 0}};
  EXPECT_TRUE(resolve_even_odd(std::vector<Loop>{loop_from_points(spike)}, kTol).empty());
  EXPECT_TRUE(unite({}, {}, kTol).empty());
}

TEST(Boolean, OrientationCountsUnderTheNonZeroRule) {
  const std::vector<Vec2> outer{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, same_way{{2, 2}, {8, 2}, {8, 8}, {2, 8}};
  const std::vector<Vec2> other_way(same_way.rbegin(), same_way.rend());
  EXPECT_NEAR(area(resolve_nonzero(std::vector{loop_from_points(outer), loop_from_points(same_way)}, kTol)),
              100, 1e-6);
  EXPECT_NEAR(area(resolve_nonzero(std::vector{loop_from_points(outer), loop_from_points(other_way)}, kTol)),
              64, 1e-6);
}

/// Thousands of places where contours touch themselves: polyclipping alone takes the square of them to split it.
TEST(Boolean, AScribbleIsResolvedEvenOdd) {
  Random random(3);
  std::vector<Vec2> points;
  for (int i = 0; i < 1000; ++i) {
    const Vec2 at = direction_of(2 * kPi * i * 7 / 1000);
    points.push_back({at.x * random.between(45, 90), at.y * random.between(45, 90)});
  }
  const std::vector<Loop> loops{loop_from_points(points)};
  const Regions regions = resolve_even_odd(loops, kTol);
  EXPECT_GT(regions.size(), 1000U);
  for (const Region& region : regions) {
    EXPECT_GT(signed_area(region.outer()), 0);
    for (const Loop& island : region.islands()) EXPECT_LT(signed_area(island), 0);
  }
  const auto is_filled = [&](Vec2 p) {
    bool filled = false;
    for (const Edge& edge : loops[0]) {
      const Vec2 a = edge.from, b = edge.to;
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) filled = !filled;
    }
    return filled;
  };
  for (int i = 0; i < 500; ++i) {
    const Vec2 p{random.between(-90, 90), random.between(-90, 90)};
    const bool near = std::any_of(loops[0].begin(), loops[0].end(),
                                  [&](const Edge& edge) { return distance(edge, p) < 0.001; });
    if (near) continue;
    EXPECT_EQ(contains(regions, p), is_filled(p)) << i;
  }
}

/// Says nothing about where the result lies: that is what the point test below is for.
TEST(Boolean, AreasOfRandomPairsAddUp) {
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    const auto shape = [&] {
      const Vec2 c{random.between(0, 20), random.between(0, 20)};
      if (random.below(2)) return one(circle(c, random.between(1, 10)));
      return one(rectangle(c, c + Vec2{random.between(1, 15), random.between(1, 15)}));
    };
    const auto a = shape(), b = shape();
    const auto both = unite(a, b, kTol), common = intersect(a, b, kTol);
    const auto only_a = subtract(a, b, kTol), only_b = subtract(b, a, kTol);
    EXPECT_NEAR(area(both) + area(common), area(a) + area(b), 1e-3) << i;
    EXPECT_NEAR(area(only_a) + area(only_b) + area(common), area(both), 1e-3) << i;
    for (int k = 0; k < 50; ++k) {
      const Vec2 p{random.between(-10, 35), random.between(-10, 35)};
      const double wall = std::min(a[0].boundary_distance(p), b[0].boundary_distance(p));
      if (wall < 0.001) continue;
      EXPECT_EQ(contains(both, p), contains(a, p) || contains(b, p)) << i;
      EXPECT_EQ(contains(common, p), contains(a, p) && contains(b, p)) << i;
      EXPECT_EQ(contains(only_a, p), contains(a, p) && !contains(b, p)) << i;
    }
    for (const auto& region : both) expect_joined(region.outer());
  }
}

/// Parts of a region share its walls, rounded anew to the grid: beside and between both run strips of a nanometre.
TEST(Boolean, PartsOfARandomRegionAreMissingFromItAfterwards) {
  Random random(3);
  for (int i = 0; i < 400; ++i) {
    std::vector<BulgeVertex> corners;
    const int count = 3 + static_cast<int>(random.below(6));
    for (int k = 0; k < count; ++k)
      corners.push_back({direction_of(2 * kPi * (k + random.between(0, 0.5)) / count) * random.between(5, 15),
                         random.below(3) == 0 ? random.between(-0.2, 0.4) : 0.0});
    const Loop outline = loop_from_bulges(corners);
    if (!broken_promise(outline, {}).empty()) continue;
    const Regions whole = one(outline);
    const Vec2 at = corners[random.below(static_cast<std::uint64_t>(count))].point;
    const Regions disc = one(circle(at * random.between(0.5, 1), random.between(1, 6)));
    const Regions part = intersect(whole, disc, kTol), rest = subtract(whole, part, kTol);
    EXPECT_NEAR(area(rest), area(whole) - area(part), 0.05) << i;
    EXPECT_NEAR(area(unite(rest, part, kTol)), area(whole), 0.05) << i;
    const Regions again = subtract(whole, rest, kTol);
    EXPECT_NEAR(area(again), area(part), 0.05) << i;
    const Regions half = intersect(rest, one(circle(at, 8)), kTol);
    EXPECT_NEAR(area(subtract(rest, half, kTol)), area(rest) - area(half), 0.05) << i;
    EXPECT_NEAR(area(subtract(whole, half, kTol)), area(whole) - area(half), 0.05) << i;
  }
}

/// An outline round the origin with up to three more points within `off` mm of each corner, every third edge an arc.
Loop outline_with_tiny_edges(Random& random, double off) {
  std::vector<BulgeVertex> vertices;
  const auto bulge = [&](double most) { return random.below(3) == 0 ? random.between(-most, most) : 0.0; };
  const int corners = 5 + static_cast<int>(random.below(8));
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * (i + random.between(-0.3, 0.3)) / corners;
    const Vec2 p = direction_of(angle) * random.between(5, 12);
    for (auto more = random.below(4); more > 0; --more)
      vertices.push_back({p + Vec2{random.between(-off, off), random.between(-off, off)}, bulge(0.5)});
    vertices.push_back({p, bulge(0.2)});
  }
  return loop_from_bulges(vertices);
}

TEST(Boolean, ArcsThatComeBackRunThroughTheirEnds) {
  Random random(52);
  for (const double off : {2e-5, 3e-4, 8e-4, 2e-3, 0.02}) {
    for (int round = 0; round < 300; ++round) {
      const Loop loop = outline_with_tiny_edges(random, off);
      for (const Region& region : resolve_even_odd({{loop}}, Tolerances{})) {
        const double left = region.box().min.x - 1;
        for (const Edge& edge : region.edges()) {
          const double from = distance(edge.from, edge.center), to = distance(edge.to, edge.center);
          EXPECT_TRUE(!edge.is_arc() || std::abs(from - to) < 1e-5) << off << ": " << from << ", " << to;
          EXPECT_FALSE(region.contains({left, edge.at(0.3).y})) << off << ", round " << round;
        }
      }
    }
  }
}

}  // namespace
}  // namespace clearcut::inline geometry
