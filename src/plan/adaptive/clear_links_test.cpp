#include "plan/adaptive/clear_links.h"

#include <gtest/gtest.h>

#include <cmath>

namespace clearcut::plan::adaptive {
namespace {

constexpr double kTool = 3;
constexpr double kFilm = 1e-3;

Regions square(double low, double high) {
  return {Region::from_valid_loops(
      loop_from_points(std::vector<Vec2>{{low, low}, {high, low}, {high, high}, {low, high}}), {})};
}

/// Nothing but the round about the middle of a square is cut, out to its walls: a post of `post` mm stands.
Ground round_a_post(double post) {
  Ground ground(square(3, 47), kTool, std::nullopt);
  for (double ring = post + kTool; ring < 40; ring += 2) {
    const Vec2 c{25, 25}, a = c + Vec2{ring, 0}, b = c - Vec2{ring, 0};
    ground.cut(Edge::arc(a, b, c, Turn::kCounterClockwise));
    ground.cut(Edge::arc(b, a, c, Turn::kCounterClockwise));
  }
  return ground;
}

/// Every point of the way, looked at closely.
void expect_free(const Way& way, Vec2 from, const Ground& ground) {
  for (const Leg& leg : way) {
    const Edge edge = leg.edge(from);
    for (int i = 0; i <= 200; ++i) {
      const Vec2 p = edge.at(i / 200.0);
      EXPECT_TRUE(ground.legal().holds(p)) << p.x << ' ' << p.y;
      EXPECT_FALSE(ground.touches(p, 0.02)) << p.x << ' ' << p.y;
    }
    from = leg.to;
  }
}

TEST(FreeWays, AreStraightWhereNothingStands) {
  const Ground ground = round_a_post(4);
  const auto way = FreeWays({}, kTool, 2 * kTool).find({5, 5}, {45, 6}, ground, kFilm);
  ASSERT_TRUE(way);
  ASSERT_EQ(way->size(), 1u);
  EXPECT_EQ(way->front().bulge, 0);
  expect_free(*way, {5, 5}, ground);
}

TEST(FreeWays, RunRoundWhatStandsOnOneArc) {
  for (const double post : {1.0, 4.0, 8.0}) {
    const Ground ground = round_a_post(post);
    for (const Vec2 from : {Vec2{10, 25}, Vec2{8, 20}, Vec2{22, 10}}) {
      const Vec2 to = Vec2{50, 50} - from + Vec2{1, 0.5};
      const auto way = FreeWays({}, kTool, 2 * kTool).find(from, to, ground, kFilm);
      ASSERT_TRUE(way) << post;
      ASSERT_EQ(way->size(), 1u);
      EXPECT_NE(way->front().bulge, 0);
      EXPECT_EQ(way->back().to, to);
      expect_free(*way, from, ground);
    }
  }
}

TEST(FreeWays, LeadNowhereThroughMaterial) {
  Ground ground(square(3, 47), kTool, std::nullopt);
  ground.cut(Edge::line({6, 6}, {12, 6}));
  ground.cut(Edge::line({40, 40}, {44, 40}));
  EXPECT_FALSE(FreeWays({}, kTool, 2 * kTool).find({6, 6}, {40, 40}, ground, kFilm));
}

}  // namespace
}  // namespace clearcut::plan::adaptive
