#include "geometry/edge.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "base/units.h"

namespace clearcut::inline geometry {
namespace {

Edge arc_by_angles(Vec2 center, double r, double start, double sweep) {
  return Edge::arc(center + direction_of(start) * r, center + direction_of(start + sweep) * r, center,
                   sweep > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
}

Edge random_edge(Random& random) {
  const Vec2 a{random.between(-10, 10), random.between(-10, 10)};
  const Vec2 b{random.between(-10, 10), random.between(-10, 10)};
  if (random.below(3) == 0) return Edge::line(a, b);
  const double bulge = std::tan(random.between(-1.0, 1.0) * kPi / 2 * 0.98);
  return Edge::from_bulge(a, b, bulge);
}

double sampled_distance(const Edge& edge, Vec2 p, int n) {
  double best = 1e300;
  for (int i = 0; i <= n; ++i) best = std::min(best, norm(p - edge.at(static_cast<double>(i) / n)));
  return best;
}

TEST(Edge, BulgeOneIsAHalfCircleOnTheRight) {
  const Edge edge = Edge::from_bulge({0, 0}, {2, 0}, 1.0);
  EXPECT_NEAR(edge.sweep(), kPi, 1e-15);
  EXPECT_NEAR(edge.radius(), 1, 1e-15);
  EXPECT_NEAR(edge.at(0.5).y, -1, 1e-15);
  EXPECT_NEAR(edge.length(), kPi, 1e-15);
}

TEST(Edge, BulgesComeBack) {
  for (const double bulge : {1e-6, -1e-6, 0.01, -0.3, 1.0, -1.0, 5.0, -300.0}) {
    const Edge edge = Edge::from_bulge({3, 4}, {13, -2}, bulge);
    EXPECT_NEAR(edge.bulge() / bulge, 1, 1e-9) << bulge;
    EXPECT_EQ(edge.turn, bulge > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
  }
}

TEST(Edge, AlmostStraightBulgeIsALineOrStaysOnItsSagitta) {
  EXPECT_FALSE(Edge::from_bulge({0, 0}, {100, 0}, 1e-9).is_arc());
  const Edge edge = Edge::from_bulge({0, 0}, {100, 0}, 1e-7);
  ASSERT_TRUE(edge.is_arc());
  EXPECT_NEAR(edge.at(0.5).x, 50, 1e-6);
  EXPECT_NEAR(edge.at(0.5).y, -5e-6, 1e-6);
  EXPECT_NEAR(edge.length(), 100, 1e-6);
}

TEST(Edge, SweepOfTinyAndAlmostFullArcs) {
  EXPECT_NEAR(arc_by_angles({5, 5}, 100, 1, 1e-9).sweep(), 1e-9, 1e-15);
  EXPECT_NEAR(arc_by_angles({5, 5}, 100, 1, 2 * kPi - 1e-6).sweep(), 2 * kPi - 1e-6, 1e-12);
  EXPECT_NEAR(arc_by_angles({5, 5}, 100, 1, -2 * kPi + 1e-6).sweep(), -2 * kPi + 1e-6, 1e-12);
  EXPECT_NEAR(arc_by_angles({0, 0}, 1, 0, kPi).sweep(), kPi, 1e-15);
  EXPECT_NEAR(arc_by_angles({0, 0}, 1, 0, -kPi).sweep(), -kPi, 1e-15);
}

TEST(Edge, EndsOfAtAndPartAreBitwise) {
  const Edge edge = Edge::from_bulge({0.1, 0.2}, {7.3, 1.9}, 0.37);
  EXPECT_EQ(edge.at(0), edge.from);
  EXPECT_EQ(edge.at(1), edge.to);
  const Edge first = edge.part(0, 0.3), second = edge.part(0.3, 1);
  EXPECT_EQ(first.from, edge.from);
  EXPECT_EQ(first.to, second.from);
  EXPECT_EQ(second.to, edge.to);
  EXPECT_NEAR(first.length() + second.length(), edge.length(), 1e-12);
}

TEST(Edge, BoxHoldsTheExtremesOfAnArc) {
  const Box box = arc_by_angles({1, 2}, 3, 0.1, 3.0).box();
  EXPECT_NEAR(box.max.y, 5, 1e-12);
  EXPECT_NEAR(box.min.y, 2 + 3 * std::sin(3.1), 1e-12);
  EXPECT_NEAR(box.min.x, 1 + 3 * std::cos(3.1), 1e-12);
  EXPECT_NEAR(box.max.x, 1 + 3 * std::cos(0.1), 1e-12);
}

TEST(Edge, TangentIsPerpendicularToTheRadius) {
  for (const double sweep : {0.5, -0.5, 4.0, -4.0}) {
    const Edge edge = arc_by_angles({1, 2}, 3, 0.7, sweep);
    for (const double t : {0.0, 0.3, 1.0}) {
      const Vec2 step = (edge.at(std::min(t + 1e-6, 1.0)) - edge.at(std::max(t - 1e-6, 0.0)));
      EXPECT_NEAR(dot(edge.tangent_at(t), unit(step)), 1, 1e-9);
      EXPECT_NEAR(dot(edge.tangent_at(t), edge.at(t) - edge.center), 0, 1e-12);
    }
  }
}

TEST(Edge, AreaOfTwoHalfCirclesIsTheDisc) {
  const double area =
      arc_by_angles({3, 4}, 2, 0, kPi).signed_area() + arc_by_angles({3, 4}, 2, kPi, kPi).signed_area();
  EXPECT_NEAR(area, 4 * kPi, 1e-12);
  // A flat bow: 2/3 chord * sagitta.
  const Edge flat = Edge::from_bulge({0, 0}, {10, 0}, 1e-4);
  EXPECT_NEAR(flat.signed_area() / (2.0 / 3 * 10 * 5e-4), 1, 1e-6);
}

TEST(Nearest, CenterOfAnArc) {
  const Edge edge = arc_by_angles({1, 1}, 2, 0.3, 1.0);
  const Nearest n = nearest(edge, {1, 1});
  EXPECT_NEAR(n.distance, 2, 1e-12);
  EXPECT_NEAR(norm(n.point - Vec2{1, 1}), 2, 1e-12);
}

TEST(Nearest, BehindAShortArcIsItsNearerEnd) {
  for (const double sweep : {1e-3, 1e-7, 1.0, kPi - 1e-9, -1e-7}) {
    const Edge edge = arc_by_angles({0, 0}, 10, 0, sweep);
    const double d = distance(edge, Vec2{-5, 0});
    EXPECT_NEAR(d, sampled_distance(edge, {-5, 0}, 100), 1e-6) << sweep;
  }
}

TEST(Nearest, AgreesWithSamplingOnRandomEdges) {
  Random random(1);
  for (int i = 0; i < 3000; ++i) {
    const Edge edge = random_edge(random);
    const Vec2 p{random.between(-15, 15), random.between(-15, 15)};
    const Nearest n = nearest(edge, p);
    ASSERT_NEAR(n.distance, distance(edge, p), 1e-9) << i;
    ASSERT_NEAR(norm(n.point - p), n.distance, 1e-8) << i;
    ASSERT_NEAR(norm(n.point - nearest_point(edge, p)), 0, 1e-12) << i;
    ASSERT_NEAR(norm(edge.at(n.t) - n.point), 0, 1e-7) << i;
    const double sampled = sampled_distance(edge, p, 400);
    ASSERT_LE(n.distance, sampled + 1e-9) << i;
    const double step = edge.length() / 400;
    ASSERT_GE(n.distance, sampled - step) << i;
  }
}

TEST(Intersections, CrossTouchMiss) {
  const Edge a = Edge::line({0, 0}, {10, 0});
  ASSERT_EQ(intersections(a, Edge::line({5, -5}, {5, 5})).size(), 1U);
  EXPECT_TRUE(intersections(a, Edge::line({5, 1}, {5, 5})).empty());
  const auto corner = intersections(a, Edge::line({10, 0}, {10, 5}));
  ASSERT_EQ(corner.size(), 1U);
  EXPECT_EQ(corner[0], (Vec2{10, 0}));
}

TEST(Intersections, SharedStretchGivesItsEnds) {
  const auto shared = intersections(Edge::line({0, 0}, {10, 0}), Edge::line({7, 0}, {12, 0}));
  ASSERT_EQ(shared.size(), 2U);
  const auto arcs = intersections(arc_by_angles({0, 0}, 5, 0, 1), arc_by_angles({0, 0}, 5, 0.5, 1));
  EXPECT_EQ(arcs.size(), 2U);
  EXPECT_TRUE(intersections(Edge::line({0, 0}, {10, 0}), Edge::line({11, 0}, {12, 0})).empty());
}

TEST(Intersections, TangentsMeetOnce) {
  EXPECT_EQ(intersections(Edge::line({-10, 5}, {10, 5}), arc_by_angles({0, 0}, 5, 0, kPi)).size(), 1U);
  EXPECT_EQ(intersections(arc_by_angles({10, 0}, 5, 1, 5), arc_by_angles({0, 0}, 5, -1, 2)).size(), 1U);
  // A fillet's end on its own wall: one contact though both stay close around it.
  EXPECT_EQ(intersections(Edge::line({0, 0}, {10, 0}), arc_by_angles({10, 5}, 5, -kPi / 2, kPi / 2)).size(),
            1U);
}

TEST(Intersections, AgreeWithDistanceOnRandomEdges) {
  Random random(2);
  int crossing = 0;
  for (int i = 0; i < 3000; ++i) {
    const Edge a = random_edge(random), b = random_edge(random);
    const auto meet = intersections(a, b);
    ASSERT_LE(meet.size(), 2U) << i;
    for (const Vec2 p : meet) {
      ASSERT_LT(distance(a, p), 1e-8) << i;
      ASSERT_LT(distance(b, p), 1e-8) << i;
    }
    double sampled = 1e300;
    for (int k = 0; k <= 300; ++k) sampled = std::min(sampled, distance(b, a.at(k / 300.0)));
    const double d = distance(a, b), step = a.length() / 300;
    ASSERT_LE(d, sampled + 1e-9) << i;
    ASSERT_GE(d, sampled - step) << i;
    crossing += meet.empty() ? 0 : 1;
  }
  EXPECT_GT(crossing, 500);
}

TEST(Distance, ArcsFacingEachOther) {
  EXPECT_NEAR(distance(arc_by_angles({0, 0}, 1, -0.5, 1), arc_by_angles({5, 0}, 1, kPi - 0.5, 1)), 3, 1e-12);
  EXPECT_NEAR(distance(arc_by_angles({0, 0}, 1, 0, 3), arc_by_angles({0, 0}, 2, 1, 1)), 1, 1e-12);
  EXPECT_NEAR(distance(Edge::line({-9, 3}, {9, 3}), arc_by_angles({0, 0}, 1, 0, kPi)), 2, 1e-12);
}

TEST(Flattened, StaysWithinTheChordBound) {
  for (const double chord : {1e-4, 0.01, 1.0}) {
    for (const double sweep : {0.01, 1.0, 3.0, 6.2}) {
      const Edge edge = arc_by_angles({0, 0}, 7, 0.2, sweep);
      std::vector<Vec2> points{edge.from};
      append_flattened(edge, chord, points);
      EXPECT_EQ(points.back(), edge.to);
      for (std::size_t i = 1; i < points.size(); ++i) {
        const double apothem = norm((points[i - 1] + points[i]) / 2.0);
        EXPECT_LE(7 - apothem, chord * (1 + 1e-6));
      }
    }
  }
}

TEST(Path, ReversedRunsBackwards) {
  const Path path{Edge::line({0, 0}, {1, 0}), Edge::from_bulge({1, 0}, {2, 0}, 0.5)};
  const Path back = reversed(path);
  EXPECT_EQ(back.front().from, (Vec2{2, 0}));
  EXPECT_EQ(back.front().turn, Turn::kClockwise);
  EXPECT_NEAR(length(back), length(path), 1e-15);
  EXPECT_NEAR(box(path).min.y, -0.25, 1e-12);
}

/// An arc through `p`, from one mm before it to one mm behind it.
Edge arc_through(Vec2 p, Vec2 heading, double radius) {
  const Vec2 center = p + left_of(heading) * radius;
  const Vec2 along = heading, inward = left_of(heading);
  const double back = radius - std::sqrt((radius - 1) * (radius + 1));
  return Edge::arc(p - along + inward * back, p + along + inward * back, center, Turn::kCounterClockwise);
}

TEST(Intersections, OfHugeCirclesAtSmallAnglesAreFound) {
  const Vec2 p{0.3, -0.2};
  for (const double radius : {1.0, 50.0, 1e3, 1e4, 1e5, 1e6}) {
    for (const double other : {2.0, 1e3, 3e5}) {
      for (const double angle : {0.7, 0.03, 1e-3, 2e-4}) {
        const Edge a = arc_through(p, {1, 0}, radius);
        const Edge b = arc_through(p, {base::cos(angle), base::sin(angle)}, other);
        const std::vector<Vec2> found = intersections(a, b);
        const bool is_there = std::any_of(found.begin(), found.end(), [&](Vec2 q) {
          return distance(p, q) * angle < 1e-8 * (1 + radius / 1e4);
        });
        EXPECT_TRUE(is_there) << "radii " << radius << ", " << other << ", angle " << angle;
      }
    }
  }
}

}  // namespace
}  // namespace clearcut::inline geometry
