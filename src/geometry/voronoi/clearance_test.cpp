#include "geometry/voronoi/clearance.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "base/units.h"

namespace clearcut::inline geometry {
namespace {

const Tolerances kTol;

Loop rectangle(Vec2 a, Vec2 b) {
  const Vec2 points[] = {a, {b.x, a.y}, b, {a.x, b.y}};
  return loop_from_points(points);
}
Loop circle(Vec2 c, double r) {
  const BulgeVertex vertices[] = {{c - Vec2{r, 0}, 1}, {c + Vec2{r, 0}, 1}};
  return loop_from_bulges(vertices);
}
Loop filleted(double w, double h, double r) {
  const double q = std::tan(kPi / 8);
  const BulgeVertex v[] = {{{r, 0}, 0},     {{w - r, 0}, q}, {{w, r}, 0},     {{w, h - r}, q},
                           {{w - r, h}, 0}, {{r, h}, q},     {{0, h - r}, 0}, {{0, r}, q}};
  return loop_from_bulges(v);
}
Region region(Loop outer, std::vector<Loop> islands = {}) {
  return Region::from_valid_loops(std::move(outer), std::move(islands));
}
void expect_closed(const Regions& regions) {
  for (const Region& r : regions) {
    std::vector<Loop> loops = r.islands();
    loops.push_back(r.outer());
    for (const Loop& loop : loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) EXPECT_EQ(loop[i].to, loop[(i + 1) % loop.size()].from);
    }
  }
}

TEST(Inset, ZeroIsTheRegionItself) {
  const Region square = region(rectangle({0, 0}, {50, 50}));
  const Regions same = inset(square, 0, kTol);
  ASSERT_EQ(same.size(), 1U);
  EXPECT_EQ(same[0].outer(), square.outer());
}

TEST(Inset, OfAnInsetThatEndsInCuspsBetweenCorridorsOfExactlyTwiceTheDistance) {
  const Vec2 points[] = {{30, 30}, {30, 50}, {40, 50}, {40, 60}, {10, 60}, {10, 50}, {0, 50},  {0, 40},
                         {10, 40}, {10, 10}, {20, 10}, {20, 0},  {30, 0},  {30, 20}, {40, 20}, {40, 30}};
  Loop outline = loop_from_points(points);
  if (signed_area(outline) < 0) outline = reversed(outline);
  const Regions first = inset(region(outline), 5, kTol);
  ASSERT_EQ(first.size(), 1U);
  // Arcs and lines meet there without an angle, so that walls of no thickness arise.
  const Regions second = inset(first.front(), 1, kTol);
  ASSERT_FALSE(second.empty());
  for (const Region& inner : second) {
    for (const Edge& edge : inner.edges())
      EXPECT_NEAR(first.front().boundary_distance(edge.at(0.5)), 1, 1e-3);
  }
}

TEST(FitLines, EndWhereTheWallsThemselvesAreTooNearNotTheirSimplification) {
  // The walls bulge inwards by less than what is simplified.
  const Vec2 points[] = {{0, 0}, {5, 0.00039}, {10, 0}, {10, 1.95}, {5, 1.99961}, {0, 2.05}};
  const Region wedge = region(loop_from_points(points));
  const auto lines = Clearance(wedge, kTol).fit_lines(1);
  ASSERT_FALSE(lines.empty());
  for (const Path& line : lines) {
    for (const Edge& edge : line) {
      EXPECT_GE(wedge.boundary_distance(edge.from), 1 - kTol.fit);
      EXPECT_GE(wedge.boundary_distance(edge.to), 1 - kTol.fit);
    }
  }
}

TEST(Inset, RectangleShrinksToARectangle) {
  const Regions r = inset(region(rectangle({0, 0}, {100, 60})), 5, kTol);
  ASSERT_EQ(r.size(), 1U);
  EXPECT_EQ(r[0].outer().size(), 4U);
  EXPECT_NEAR(r[0].area(), 90 * 50, 1e-6);
  expect_closed(r);
}

TEST(Inset, TriangleOfThePaper) {
  const double s = 79.9861;
  const Vec2 points[] = {{0, 0}, {s, 0}, {s / 2, s * std::sqrt(3.0) / 2}};
  const Regions r = inset(region(loop_from_points(points)), 5, kTol);
  ASSERT_EQ(r.size(), 1U);
  ASSERT_EQ(r[0].outer().size(), 3U);
  const Box b = r[0].box();
  EXPECT_NEAR(b.min.x, 8.6603, 1e-3);
  EXPECT_NEAR(b.min.y, 5.0, 1e-3);
  EXPECT_NEAR(b.max.x, 71.3259, 1e-3);
}

TEST(Inset, ArcsStayConcentric) {
  const Regions r = inset(region(filleted(100, 60, 10)), 4, kTol);
  ASSERT_EQ(r.size(), 1U);
  ASSERT_EQ(r[0].outer().size(), 8U);
  for (const Edge& e : r[0].outer()) {
    if (e.is_arc()) {
      EXPECT_NEAR(e.radius(), 6, 1e-9);
    }
  }
  EXPECT_NEAR(r[0].area(), 92 * 52 - (4 - kPi) * 36, 1e-6);
}

TEST(Inset, ArcsOfTheCuttersRadiusVanish) {
  for (const double noise : {0.0, 1e-7, -1e-7, 2e-4, -2e-4, -0.006}) {
    const Regions r = inset(region(filleted(100, 60, 5 + noise)), 5, kTol);
    ASSERT_EQ(r.size(), 1U) << noise;
    EXPECT_EQ(r[0].outer().size(), 4U) << noise;
    EXPECT_NEAR(r[0].area(), 90 * 50, 1e-3) << noise;
  }
  EXPECT_EQ(inset(region(filleted(100, 60, 5.006)), 5, kTol)[0].outer().size(), 8U);
}

TEST(Inset, ReflexCornerIsAnExactArc) {
  const Vec2 points[] = {{0, 0}, {60, 0}, {60, 30}, {30, 30}, {30, 60}, {0, 60}};
  const Regions r = inset(region(loop_from_points(points)), 10, kTol);
  ASSERT_EQ(r.size(), 1U);
  int arcs = 0;
  for (const Edge& e : r[0].outer()) {
    if (!e.is_arc()) continue;
    ++arcs;
    EXPECT_NEAR(norm(e.center - Vec2{30, 30}), 0, 1e-9);
    EXPECT_NEAR(e.radius(), 10, 1e-9);
    EXPECT_EQ(e.turn, Turn::kClockwise);
  }
  EXPECT_EQ(arcs, 1);
  expect_closed(r);
}

TEST(Inset, IslandsGrowAndMeet) {
  const Region r = region(rectangle({0, 0}, {100, 60}), {circle({35, 30}, 8), rectangle({60, 25}, {70, 35})});
  const Regions apart = inset(r, 5, kTol);
  ASSERT_EQ(apart.size(), 1U);
  EXPECT_EQ(apart[0].islands().size(), 2U);
  const Regions met = inset(r, 9, kTol);
  ASSERT_EQ(met.size(), 1U);
  EXPECT_EQ(met[0].islands().size(), 1U);
  EXPECT_TRUE(inset(r, 40, kTol).empty());
}

TEST(Inset, NecksSplit) {
  const Vec2 points[] = {{0, 0},   {30, 0},  {30, 10}, {50, 10}, {50, 0},  {80, 0},
                         {80, 30}, {50, 30}, {50, 18}, {30, 18}, {30, 30}, {0, 30}};
  const Clearance c(region(loop_from_points(points)), kTol);
  EXPECT_EQ(c.inset(3.9).size(), 1U);
  EXPECT_EQ(c.inset(4.1).size(), 2U);
  EXPECT_EQ(c.centers().size(), 2U);
  EXPECT_NEAR(c.max(), 15, 1e-3);
}

TEST(Inset, FarFromTheOriginAndVerySmall) {
  const Vec2 far{20000, -30000};
  const Regions r = inset(region(rectangle(far, far + Vec2{100, 60})), 5, kTol);
  ASSERT_EQ(r.size(), 1U);
  EXPECT_NEAR(r[0].area(), 90 * 50, 1e-6);
  const Regions small = inset(region(circle({1, 1}, 0.05)), 0.03, kTol);
  ASSERT_EQ(small.size(), 1U);
  EXPECT_NEAR(small[0].area(), kPi * 0.02 * 0.02, 1e-7);
}

TEST(Inset, SmallerThanTheGridIsNothing) {
  EXPECT_TRUE(inset(region(rectangle({1, 1}, {1.00002, 1.00002})), 0.001, kTol).empty());
  EXPECT_TRUE(inset(region(circle({1, 1}, 2e-5)), 0.001, kTol).empty());
}

TEST(Inset, IslandLeaningOnAWallIsPartOfIt) {
  const Regions r = inset(region(rectangle({0, 0}, {100, 60}), {rectangle({40, 0}, {60, 20})}), 5, kTol);
  ASSERT_EQ(r.size(), 1U);
  EXPECT_TRUE(r[0].islands().empty());
  EXPECT_NEAR(r[0].area(), 90 * 50 - 30 * 20 + (50 - 12.5 * kPi), 1e-6);
}

TEST(Inset, WallOfNoThicknessIsAWall) {
  const Vec2 there_and_back[] = {{40, 30}, {60, 30}};
  const Regions r = inset(region(rectangle({0, 0}, {100, 60}), {loop_from_points(there_and_back)}), 5, kTol);
  ASSERT_EQ(r.size(), 1U);
  EXPECT_NEAR(r[0].area(), 90 * 50 - 20 * 10 - 25 * kPi, 1e-6);
  const Vec2 slit[] = {{0, 0}, {100, 0}, {100, 60}, {50, 60}, {50, 30}, {50, 60}, {0, 60}};
  const Regions around = inset(region(loop_from_points(slit)), 5, kTol);
  EXPECT_NEAR(area(around), 90 * 50 - 25 * 10 - 12.5 * kPi, 1e-6);
}

TEST(Inset, IslandSmallerThanTheGridStillKeepsItsDistance) {
  const Regions r = inset(region(rectangle({0, 0}, {100, 60}), {circle({50, 30}, 1e-5)}), 5, kTol);
  ASSERT_EQ(r.size(), 1U);
  EXPECT_NEAR(r[0].area(), 90 * 50 - 25 * kPi, 1e-2);
}

TEST(Inset, LevelsAtOnceAreTheLevelsOneByOne) {
  const Clearance c(region(filleted(100, 60, 10), {circle({40, 30}, 6)}), kTol);
  const std::vector<double> levels{0, 2, 5, 5, 11, 40};
  const auto all = c.insets(levels);
  ASSERT_EQ(all.size(), levels.size());
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const Regions one = c.inset(levels[i]);
    ASSERT_EQ(all[i].size(), one.size()) << levels[i];
    for (std::size_t k = 0; k < one.size(); ++k) EXPECT_EQ(all[i][k].outer(), one[k].outer());
  }
}

TEST(Dilate, SquareGetsRoundCorners) {
  const Regions r = dilate({region(rectangle({0, 0}, {20, 10}))}, 3, kTol);
  ASSERT_EQ(r.size(), 1U);
  EXPECT_EQ(r[0].outer().size(), 8U);
  EXPECT_NEAR(area(r), 200 + 60 * 3 + 9 * kPi, 1e-6);
}

TEST(Dilate, IslandsShrinkAndBaysClose) {
  const Regions ring =
      dilate({region(rectangle({0, 0}, {40, 40}), {rectangle({10, 10}, {30, 30})})}, 3, kTol);
  ASSERT_EQ(ring.size(), 1U);
  EXPECT_NEAR(area(ring), 1600 + 160 * 3 + 9 * kPi - 14 * 14, 1e-6);
  const Vec2 c[] = {{0, 0},   {40, 0},  {40, 19}, {30, 19}, {30, 10}, {10, 10},
                    {10, 30}, {30, 30}, {30, 21}, {40, 21}, {40, 40}, {0, 40}};
  const Regions closed = dilate({region(loop_from_points(c))}, 3, kTol);
  ASSERT_EQ(closed.size(), 1U);
  EXPECT_EQ(closed[0].islands().size(), 1U);
}

TEST(Dilate, NeighboursMerge) {
  const Regions two{region(rectangle({0, 0}, {10, 10})), region(rectangle({14, 0}, {24, 10}))};
  EXPECT_EQ(dilate(two, 1, kTol).size(), 2U);
  EXPECT_EQ(dilate(two, 3, kTol).size(), 1U);
}

TEST(FitLines, SlotOfTheCuttersWidthIsOneLine) {
  const Clearance c(region(rectangle({0, 0}, {30, 2})), kTol);
  EXPECT_TRUE(c.inset(1).empty());
  const auto lines = c.fit_lines(1);
  ASSERT_EQ(lines.size(), 1U);
  ASSERT_EQ(lines[0].size(), 1U);
  EXPECT_NEAR(length(lines[0]), 28, 0.01);
  EXPECT_TRUE(c.fit_lines(0.9).empty());
  EXPECT_TRUE(c.fit_lines(1.1).empty());
}

TEST(FitLines, SlotBetweenTwoRooms) {
  const Vec2 points[] = {{0, 0},   {30, 0},  {30, 10}, {50, 10}, {50, 0},  {80, 0},
                         {80, 30}, {50, 30}, {50, 18}, {30, 18}, {30, 30}, {0, 30}};
  const Clearance c(region(loop_from_points(points)), kTol);
  EXPECT_EQ(c.inset(4).size(), 2U);
  const auto lines = c.fit_lines(4);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(length(lines[0]), 20, 0.2);
}

TEST(FitLines, RingSlotGivesAClosedCurve) {
  const Clearance c(region(circle({0, 0}, 12), {circle({0, 0}, 8)}), kTol);
  EXPECT_TRUE(c.inset(2).empty());
  const auto lines = c.fit_lines(2);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].front().from, lines[0].back().to);
  EXPECT_NEAR(length(lines[0]), 20 * kPi, 1e-6);
  EXPECT_EQ(c.inset(1.9).size(), 1U);
}

/// The one place of a hole of exactly the cutter's diameter, within rounding.
void expect_one_point(const Region& hole, double radius, Vec2 place) {
  const Clearance c(hole, kTol);
  EXPECT_TRUE(c.inset(radius).empty());
  const auto lines = c.fit_lines(radius);
  ASSERT_EQ(lines.size(), 1U);
  ASSERT_EQ(lines[0].size(), 1U);
  EXPECT_EQ(lines[0][0].from, lines[0][0].to);
  EXPECT_NEAR(norm(lines[0][0].from - place), 0, 1e-4);
  EXPECT_TRUE(c.fit_lines(radius * 0.99).empty());
  EXPECT_TRUE(c.fit_lines(radius * 1.01).empty());
}

TEST(FitLines, HolesOfTheCuttersSizeGiveAPoint) {
  expect_one_point(region(circle({1.2345678, 3.7654321}, 5)), 5, {1.2345678, 3.7654321});
  expect_one_point(region(circle({5, 5}, 4.9998)), 5, {5, 5});
  expect_one_point(region(rectangle({0, 0}, {10, 10})), 5, {5, 5});
  for (const int corners : {3, 6, 24}) {
    std::vector<Vec2> points;
    const double reach = 5 / std::cos(kPi / corners);
    for (int i = 0; i < corners; ++i)
      points.push_back(Vec2{7, -3} + direction_of(0.3 + 2 * kPi * i / corners) * reach);
    expect_one_point(region(loop_from_points(points)), 5, {7, -3});
  }
}

TEST(FitLines, AHoleAtTheEndOfANarrowSlotGivesAPoint) {
  const double h = 2, x = std::sqrt(25 - h * h), sweep = 2 * kPi - 2 * std::asin(h / 5);
  const BulgeVertex outline[] = {{{x, h}, std::tan(sweep / 4)}, {{x, -h}, 0}, {{20, -h}, 0}, {{20, h}, 0}};
  expect_one_point(region(loop_from_bulges(outline)), 5, {0, 0});
}

TEST(FitLines, AHoleALittleLongerThanWideGivesALine) {
  const Clearance c(region(rectangle({0, 0}, {10.05, 10})), kTol);
  const auto lines = c.fit_lines(5);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(length(lines[0]), 0.05, 0.005);
}

TEST(FitLines, PolygonHoleWiderThanTheCutterIsARegion) {
  std::vector<Vec2> points;
  for (int i = 0; i < 24; ++i) points.push_back(direction_of(2 * kPi * i / 24) * (1.65 / std::cos(kPi / 24)));
  const Clearance c(region(loop_from_points(points)), kTol);
  EXPECT_EQ(c.inset(3.175 / 2).size(), 1U);
  EXPECT_TRUE(c.fit_lines(3.175 / 2).empty());
  EXPECT_NEAR(c.max(), 1.65, 1e-4);
}

/// A box whose right side bows out on an arc that is given in many pieces, their ends a little off the circle.
Loop bow_in_pieces(double radius, int pieces) {
  const double half = 1;
  Random random(7);
  const auto at = [&](double angle) { return direction_of(angle) * (radius - random.between(0, 1e-4)); };
  Loop loop;
  for (int i = 0; i < pieces; ++i) {
    const Vec2 from = i == 0 ? at(-half) : loop.back().to, to = at(-half + 2 * half * (i + 1) / pieces);
    loop.push_back(Edge::arc(from, to, {0, 0}, Turn::kCounterClockwise));
  }
  const Vec2 first = loop.front().from, last = loop.back().to, left{-0.7 * radius, 0};
  loop.push_back(Edge::line(last, {left.x, last.y}));
  loop.push_back(Edge::line({left.x, last.y}, {left.x, first.y}));
  loop.push_back(Edge::line({left.x, first.y}, first));
  return loop;
}

TEST(FitLines, AnArcInPiecesHasNoPlacesOfItsOwn) {
  for (const int pieces : {2, 3, 17, 70}) {
    const Region outline = region(bow_in_pieces(13.616, pieces));
    const Clearance clearance(outline, kTol);
    for (double d = 0.5; d < 11; d += 0.13) EXPECT_TRUE(clearance.fit_lines(d).empty()) << pieces << " " << d;
  }
}

TEST(Centers, CircleSquareAndRidge) {
  const Clearance round(region(circle({3, 4}, 7)), kTol);
  ASSERT_EQ(round.centers().size(), 1U);
  EXPECT_NEAR(norm(round.centers()[0].point - Vec2{3, 4}), 0, 1e-6);
  EXPECT_NEAR(round.max(), 7, 1e-9);
  const Clearance ridge(region(rectangle({0, 0}, {100, 20})), kTol);
  ASSERT_EQ(ridge.centers().size(), 1U);
  EXPECT_NEAR(norm(ridge.centers()[0].point - Vec2{50, 10}), 0, 1e-3);
}

TEST(Axis, RectangleHasFiveEdges) {
  const Clearance c(region(rectangle({0, 0}, {100, 20})), kTol);
  EXPECT_EQ(c.axis().edges.size(), 5U);
  EXPECT_EQ(c.axis().points.size(), 6U);
}

TEST(Axis, FilletsLeaveTheRidgeAndItsForks) {
  const Clearance c(region(filleted(100, 20, 5)), kTol);
  for (const AxisEdge& e : c.axis().edges) {
    EXPECT_GE(c.axis().points[e.a].clearance, 5 - 1e-3);
    EXPECT_GE(c.axis().points[e.b].clearance, 5 - 1e-3);
  }
}

/// A lens 7 um thick between an arc and two lines: tangents for the arc would lie on the other side of the lines.
TEST(Clearance, AThinIslandBesideAnArcStays) {
  const Vec2 a{83.292803407, 82.272190488}, b{83.342987450, 82.086658918}, middle{83.330840600, 82.182619034};
  const Vec2 center{82.649137424, 81.998533761};
  const Region lens = Region::from_valid_loops(
      {Edge::arc(a, b, center, Turn::kClockwise), Edge::line(b, middle), Edge::line(middle, a)}, {});
  const Tolerances tol;
  for (const double d : {0.005, 0.03, 0.0640625, 0.1, 0.3}) {
    const Regions rest =
        inset(Region::from_valid_loops(rectangle(lens.box().min - Vec2{2, 2}, lens.box().max + Vec2{2, 2}),
                                       {lens.outer()}),
              d, tol);
    ASSERT_EQ(rest.size(), 1U) << d;
    ASSERT_EQ(rest[0].islands().size(), 1U) << d;
    // Steiner's formula for what is convex but for 7 um.
    const double grown = lens.area() + d * length(lens.outer()) + kPi * d * d;
    EXPECT_NEAR(-signed_area(rest[0].islands()[0]), grown, 0.01 * grown + 1e-5) << d;
  }
}

void expect_same(const Regions& a, const Regions& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].outer(), b[i].outer());
    EXPECT_EQ(a[i].islands(), b[i].islands());
  }
}

TEST(Clearance, LevelsAreTheSameInWhateverOrderTheyAreAskedFor) {
  const Region part =
      region(filleted(60, 40, 6), {reversed(circle({20, 20}, 5)), reversed(circle({40, 20}, 4))});
  const Clearance clearance(part, kTol);
  for (const double d : {5.0, 0.5, 3.0, 7.0, 6.9, 0.01, 5.0, 12.0})
    expect_same(clearance.inset(d), inset(part, d, kTol));
  const auto several = clearance.insets({0.0, 0.5, 4.0, 7.0});
  for (std::size_t i = 0; i < several.size(); ++i)
    expect_same(several[i], inset(part, std::vector{0.0, 0.5, 4.0, 7.0}[i], kTol));
}

TEST(Clearance, KeptOnesAnswerAsThoseMadeForThemselves) {
  const Region one = region(filleted(60, 40, 6), {reversed(circle({20, 20}, 5))});
  const Region other = region(filleted(60, 40, 6), {reversed(circle({20, 20}, 5.001))});
  Tolerances wide = kTol;
  wide.fit = 0.05;
  const Regions of_one = inset(one, 3, kTol), of_other = inset(other, 3, kTol);
  const auto lines = Clearance(other, wide).fit_lines(10, 0);
  const KeptClearances kept;
  for (int round = 0; round < 2; ++round) {
    expect_same(inset(one, 3, kTol), of_one);
    expect_same(inset(other, 3, kTol), of_other);
    EXPECT_EQ(Clearance(other, wide).fit_lines(10, 0), lines);
  }
}

TEST(Dilate, GrowsWhatABooleanLeavesWithATipThatCrossesItself) {
  const std::vector<BulgeVertex> corners{{{4.3962000099372318, 0.017965846110231165}, 0.18914423630644867},
                                         {{4.6200732391528598, 0.30652816036290703}, 0},
                                         {{4.6199585359123434, 0.30613832622866594}, -0.25300661999846641},
                                         {{4.2371120781991705, 0.016065617108206125}, 0}};
  const Region sliver = Region::from_valid_loops(loop_from_bulges(corners), {});
  const Regions grown = dilate({sliver}, 1, Tolerances{});
  ASSERT_EQ(grown.size(), 1u);
  for (double angle = 0; angle < 2 * kPi; angle += 0.01) {
    const Vec2 p = Vec2{4.4, 0.15} + direction_of(angle) * 2;
    const double d = sliver.boundary_distance(p);
    EXPECT_NEAR(grown[0].boundary_distance(p), d - 1, 2e-3) << angle;
  }
}

}  // namespace
}  // namespace clearcut::inline geometry
