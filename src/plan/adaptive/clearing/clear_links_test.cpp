#include "plan/adaptive/clearing/clear_links.h"

#include <gtest/gtest.h>

#include <cmath>

namespace clearcut::plan::adaptive {
namespace {

constexpr double kTool = 3;
constexpr double kResidual = 1e-3;

Regions square(double low, double high) {
  return {Region::from_valid_loops(
      loop_from_points(std::vector<Vec2>{{low, low}, {high, low}, {high, high}, {low, high}}), {})};
}

/// Nothing but the round about the middle of a square is cut, out to its walls: a post of `post` mm stands.
RemainingStock round_a_post(double post) {
  RemainingStock remaining(square(3, 47), kTool, std::nullopt);
  for (double ring = post + kTool; ring < 40; ring += 2) {
    const Vec2 c{25, 25}, a = c + Vec2{ring, 0}, b = c - Vec2{ring, 0};
    remaining.cut(Edge::arc(a, b, c, Turn::kCounterClockwise));
    remaining.cut(Edge::arc(b, a, c, Turn::kCounterClockwise));
  }
  return remaining;
}

/// Every point of the way, looked at closely.
void expect_free(const LinkPath& link, Vec2 from, const RemainingStock& remaining) {
  for (const LinkMove& move : link) {
    const Edge edge = move.edge(from);
    for (int i = 0; i <= 200; ++i) {
      const Vec2 p = edge.at(i / 200.0);
      EXPECT_TRUE(remaining.legal().holds(p)) << p.x << ' ' << p.y;
      EXPECT_FALSE(remaining.touches(p, 0.02)) << p.x << ' ' << p.y;
    }
    from = move.to;
  }
}

TEST(ClearLinks, AreStraightWhereNothingStands) {
  const RemainingStock remaining = round_a_post(4);
  const auto link = ClearLinks({}, kTool, 2 * kTool).find({5, 5}, {45, 6}, remaining, kResidual);
  ASSERT_TRUE(link);
  ASSERT_EQ(link->size(), 1u);
  EXPECT_EQ(link->front().bulge, 0);
  expect_free(*link, {5, 5}, remaining);
}

TEST(ClearLinks, RunRoundWhatStandsOnOneArc) {
  for (const double post : {1.0, 4.0, 8.0}) {
    const RemainingStock remaining = round_a_post(post);
    for (const Vec2 from : {Vec2{10, 25}, Vec2{8, 20}, Vec2{22, 10}}) {
      const Vec2 to = Vec2{50, 50} - from + Vec2{1, 0.5};
      const auto link = ClearLinks({}, kTool, 2 * kTool).find(from, to, remaining, kResidual);
      ASSERT_TRUE(link) << post;
      ASSERT_EQ(link->size(), 1u);
      EXPECT_NE(link->front().bulge, 0);
      EXPECT_EQ(link->back().to, to);
      expect_free(*link, from, remaining);
    }
  }
}

TEST(ClearLinks, LeadNowhereThroughMaterial) {
  RemainingStock remaining(square(3, 47), kTool, std::nullopt);
  remaining.cut(Edge::line({6, 6}, {12, 6}));
  remaining.cut(Edge::line({40, 40}, {44, 40}));
  EXPECT_FALSE(ClearLinks({}, kTool, 2 * kTool).find({6, 6}, {40, 40}, remaining, kResidual));
}

}  // namespace
}  // namespace clearcut::plan::adaptive
