#include "plan/common/air_cuts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.h"
#include "geometry/edge.h"
#include "geometry/region.h"

namespace clearcut::plan {
namespace {

constexpr double kToolRadius = 3;

const Machine& machine() {
  static const Machine one;
  return one;
}

const RetractLink& retract() {
  static const RetractLink one(machine(), MmPerMin::of(1000), {10, 3});
  return one;
}

Pass straight(const std::vector<Vec2>& points, int parent = -1) {
  Pass pass;
  pass.path = line_path(points);
  pass.parent = parent;
  pass.reversible = false;
  return pass;
}

Pass ring_round(const Box& box, int parent = -1) {
  Pass pass = straight({}, parent);
  pass.path = rectangle(box);
  pass.closed = true;
  return pass;
}

/// A target in air, `passes` around and over it.
LayerPasses layer_of(const Box& target, std::vector<Pass> passes) {
  LayerPasses layer;
  layer.z_top = 2;
  layer.target = {rectangular_region(target)};
  layer.legal = {rectangular_region(target.grown(100))};
  layer.passes = std::move(passes);
  return layer;
}

std::optional<LayerPasses> shortened(const LayerPasses& layer, bool keeps_direction = false) {
  return without_air_cuts(layer, {kToolRadius, MmPerMin::of(1000), &retract(), keeps_direction});
}

double distance_to(const std::vector<Pass>& passes, Vec2 p) {
  double least = 1e9;
  for (const Pass& pass : passes)
    for (const Edge& edge : pass.path) least = std::min(least, distance(edge, p));
  return least;
}

TEST(AirCuts, ARingInTheAirGoesAndWhatWaitedForItWaitsNoLonger) {
  const Box target{{0, 0}, {20, 5}};
  const auto layer =
      shortened(layer_of(target, {ring_round(target.grown(20)), straight({{2.5, 2.5}, {17.5, 2.5}}, 0),
                                  straight({{0, 2.5}, {20, 2.5}}, 0)}));
  ASSERT_TRUE(layer);
  ASSERT_EQ(layer->passes.size(), 1U);
  EXPECT_EQ(layer->passes[0].parent, -1);
  EXPECT_LE(length(layer->passes[0].path), 20);
}

TEST(AirCuts, ALineEndsWhereNothingIsLeftToCut) {
  const auto layer = shortened(layer_of({{0, 0}, {20, 5}}, {straight({{-30, 2.5}, {50, 2.5}})}));
  ASSERT_TRUE(layer);
  // The corners of the target are cleared from sqrt(3^2 - 2.5^2) mm inside.
  EXPECT_LT(length(layer->passes[0].path), 18);
  EXPECT_GE(length(layer->passes[0].path), 20 - 2 * 1.66);
}

TEST(AirCuts, ARingOpensWhereItRunsThroughAir) {
  // The target lies under the lower side alone; the ring inside waits for nothing.
  const LayerPasses ring = layer_of({{0, -2}, {30, 2}}, {ring_round({{-5, 0}, {35, 30}})});
  const auto layer = shortened(ring);
  ASSERT_TRUE(layer);
  ASSERT_EQ(layer->passes.size(), 1U);
  EXPECT_FALSE(layer->passes[0].closed);
  EXPECT_FALSE(layer->passes[0].reversible) << "it follows a wall";
  EXPECT_LT(length(layer->passes[0].path), 30);
}

TEST(AirCuts, PartsOfARingAreCutToAndFroUnlessTheDirectionIsAsked) {
  LayerPasses two =
      layer_of({{0, -2}, {30, 2}}, {straight({{0, -1}, {30, -1}}), ring_round({{-5, 2}, {35, 30}}, 0)});
  for (const bool asked : {false, true}) {
    const auto layer = shortened(two, asked);
    ASSERT_TRUE(layer);
    ASSERT_EQ(layer->passes.size(), 2U);
    EXPECT_EQ(layer->passes[1].reversible, !asked);
    EXPECT_EQ(layer->passes[1].parent, 0);
  }
}

TEST(AirCuts, NothingIsTakenFromPassesThatAllCut) {
  EXPECT_FALSE(shortened(layer_of({{0, 0}, {30, 6}}, {straight({{0, 3}, {30, 3}})})));
}

/// Between two islands of material a long way through air is worth a retract.
TEST(AirCuts, ALongWayThroughAirPartsAPass) {
  LayerPasses far =
      layer_of({{0, 0}, {10, 6}}, {straight({{0, 3}, {10, 3}, {10, 200}, {100, 200}, {100, 3}, {110, 3}})});
  far.target.push_back(rectangular_region({{100, 0}, {110, 6}}));
  const auto layer = shortened(far);
  ASSERT_TRUE(layer);
  ASSERT_EQ(layer->passes.size(), 2U);
  EXPECT_LT(length(layer->passes[0].path) + length(layer->passes[1].path), 30);
}

/// Random lines over a target, of which most clear what others clear, too: every place that was cleared still is.
TEST(AirCuts, WhatWasClearedStaysCleared) {
  int shorter = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    const auto point = [&] { return Vec2{random.between(-10, 50), random.between(-10, 40)}; };
    std::vector<Pass> passes;
    for (int i = 0; i < 12; ++i) passes.push_back(straight({point(), point(), point()}, i - 1));
    passes.push_back(ring_round({{5, 5}, {25, 25}}, 0));
    LayerPasses before = layer_of({{0, 0}, {40, 30}}, passes);
    before.target = {disc_about({15, 15}, 14), rectangular_region({{32, 2}, {40, 30}})};
    const auto after = shortened(before);
    if (!after) continue;
    ++shorter;
    for (int i = 0; i < 3000; ++i) {
      const Vec2 p = i % 3 == 0
                         ? before.target[0].outer()[0].center + direction_of(random.between(0, 6.3)) * 13.9999
                         : Vec2{random.between(0, 40), random.between(0, 30)};
      if (!contains(before.target, p) || distance_to(before.passes, p) > kToolRadius - 1.1e-3) continue;
      EXPECT_LE(distance_to(after->passes, p), kToolRadius) << seed << ": " << p.x << " " << p.y;
    }
  }
  EXPECT_GT(shorter, 6);
}

}  // namespace
}  // namespace clearcut::plan
