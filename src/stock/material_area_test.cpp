#include <gtest/gtest.h>

#include "stock/material.h"

namespace clearcut::stock {
namespace {

void add(Material& material, const Edge& path, double radius) {
  material.add({path, -1, -1, MoveKind::kCut, MmPerMin::of(1000), 0}, radius);
}

/// All of a disc is cut but a post about `at`, by rings that turn about it and go outwards.
Material around_a_post(Vec2 at, double post, double reach) {
  Material material(std::nullopt, 0, {2, reach});
  for (double r = post + 2; r < 2 * reach; r += 3) {
    add(material, Edge::arc(at + Vec2{r, 0}, at - Vec2{r, 0}, at, Turn::kCounterClockwise), 2);
    add(material, Edge::arc(at - Vec2{r, 0}, at + Vec2{r, 0}, at, Turn::kCounterClockwise), 2);
  }
  return material;
}

Edge disc(Vec2 p) {
  return Edge::line(p, p);
}

/// Posts between the circles that samples were once taken on.
TEST(MaterialArea, FindsASmallPostUnderALargeCutter) {
  for (const Vec2 post : {Vec2{17.5, 0}, Vec2{0, 12.4}, Vec2{-7.4, 2}, Vec2{0, 0}}) {
    const Material material = around_a_post(post, 1.5, 25);
    EXPECT_TRUE(material.in_reach(disc({0, 0}), 25, -0.5).has_value());
    EXPECT_FALSE(material.in_reach(disc({0, 0}), 25, 0.1).has_value());
  }
  const Material thin = around_a_post({1.5, 0.4}, 0.05, 3);
  const auto found = thin.in_reach(disc({0, 0}), 3, -0.5);
  ASSERT_TRUE(found.has_value());
  EXPECT_LT(distance(*found, Vec2{1.5, 0.4}), 0.05);
}

TEST(MaterialArea, FindsNothingWhereAllIsCut) {
  Material material(std::nullopt, 0, {3});
  for (double y = -9; y <= 9; y += 5.5) add(material, Edge::line({-9, y}, {9, y}), 3);
  EXPECT_FALSE(material.in_reach(disc({0, 0}), 6, -0.5).has_value());
  EXPECT_FALSE(material.in_reach(Edge::line({-5, 0}, {5, 0}), 5, -0.5).has_value());
  EXPECT_TRUE(material.in_reach(disc({0, 0}), 6, -1.5).has_value()) << "below what was cut";
  EXPECT_TRUE(material.in_reach(Edge::line({-5, 0}, {12, 0}), 3, -0.5).has_value()) << "beyond what was cut";
}

/// Two rings with a gap between them; `slope`: a cone goes down a ramp beside them, so that cutters with a profile are asked for.
Material two_rings(double gap, bool slope) {
  Material material(std::nullopt, 0, {4});
  for (const double r : {2.0, 10 + gap}) {
    add(material, Edge::arc({r, 0}, {-r, 0}, {0, 0}, Turn::kCounterClockwise), 4);
    add(material, Edge::arc({-r, 0}, {r, 0}, {0, 0}, Turn::kCounterClockwise), 4);
  }
  if (slope) {
    const int cone = material.add_cutter({0, 0, 1, 0.5}, 0.5);
    material.add_sweep({Edge::line({0, 0}, {1, 0}), -0.1, -0.4, MoveKind::kRamp, MmPerMin::of(300), 0}, cone);
  }
  return material;
}

TEST(MaterialArea, SliversOfAStatedThicknessDoNotCount) {
  for (const bool slope : {false, true}) {
    const auto found = [&](double gap, double sliver) {
      return two_rings(gap, slope)
          .in_reach(disc({0.3, 0.1}), 13, -0.5, Material::kCylinder, sliver)
          .has_value();
    };
    for (const double gap : {0.001, 0.004, 0.009}) EXPECT_FALSE(found(gap, 0.01)) << gap << " " << slope;
    for (const double gap : {0.1, 1.0}) EXPECT_TRUE(found(gap, 0.01)) << gap << " " << slope;
    EXPECT_TRUE(found(0.1, 0));
  }
}

TEST(MaterialArea, FindsTheOnePostAmongManyMoves) {
  Material material(std::nullopt, 0, {3});
  const Vec2 post{60, 60};
  for (double y = -6; y <= 126; y += 5) {
    for (double x = -6; x <= 126; x += 2) {
      const Edge move = Edge::line({x, y}, {x + 2, y});
      if (distance(move, post) > 3.5) add(material, move, 3);
    }
  }
  for (double y = 0; y <= 120; y += 5) {
    for (double x = 0; x <= 120; x += 5) {
      const double away = distance(post, Vec2{x, y});
      if (away > 2.5 && away < 9) continue;
      const bool found = material.in_reach(disc({x, y}), 2.9, -0.5).has_value();
      EXPECT_EQ(found, away < 2.5) << x << " " << y;
    }
  }
  EXPECT_TRUE(material.in_reach(Edge::line({0, 60}, {120, 60}), 2.9, -0.5).has_value()) << "a long path";
  EXPECT_TRUE(material.in_reach(disc({30, 30}), 60, -0.5).has_value()) << "wider than the cutter";
  EXPECT_FALSE(material.in_reach(disc({30, 30}), 30, -0.5).has_value()) << "wider than the cutter";
}

TEST(MaterialArea, BesideTheBlockThereIsNothing) {
  const Material material(Box{{0, 0}, {10, 10}}, 0, {3});
  EXPECT_FALSE(material.in_reach(disc({-3.1, 5}), 3, -1).has_value());
  EXPECT_TRUE(material.in_reach(disc({-2.9, 5}), 3, -1).has_value());
}

}  // namespace
}  // namespace clearcut::stock
