#include "plan/adaptive/clearing/cleared_cells.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "stock/material.h"

namespace clearcut::plan::adaptive {
namespace {

constexpr double kRadius = 3;

/// A run of lines and arcs of all sizes, some of them more than a half turn, some points.
std::vector<Edge> random_cuts(Random& random) {
  std::vector<Edge> cuts;
  Vec2 at{random.between(5, 35), random.between(5, 35)};
  for (int i = 0; i < 12; ++i) {
    const Vec2 to{random.between(5, 35), random.between(5, 35)};
    const auto kind = random.below(4);
    Edge cut = Edge::line(at, to);
    if (kind == 1) cut = Edge::from_bulge(at, to, random.between(-2, 2));
    if (kind == 2) cut = Edge::line(at, at + (to - at) / 40.0);
    if (kind == 3) cut = Edge::line(to, to);
    cuts.push_back(cut);
    at = cut.to;
  }
  return cuts;
}

stock::Material material_after(const std::vector<Edge>& cuts) {
  stock::Material material(std::nullopt, 0, {kRadius});
  for (const Edge& cut : cuts) material.add({cut, -1, -1, MoveKind::kCut, {}, 0}, kRadius);
  return material;
}

/// Nothing stands at a grid of points of the disc.
bool is_cleared(const stock::Material& material, Vec2 center, double radius) {
  for (double x = -radius; x <= radius; x += radius / 12) {
    for (double y = -radius; y <= radius; y += radius / 12) {
      if (x * x + y * y <= radius * radius && !material.is_removed(center + Vec2{x, y}, -1)) return false;
    }
  }
  return true;
}

// What it says is cleared is cleared; and of what is, it knows most.
TEST(ClearedCells, NeverClaimTooMuch) {
  Random random(17);
  int known = 0, cleared = 0;
  for (int run = 0; run < 40; ++run) {
    const auto cuts = random_cuts(random);
    const stock::Material material = material_after(cuts);
    ClearedCells cells(Box{{0, 0}, {40, 40}}, kRadius / 8);
    for (const Edge& cut : cuts) cells.add(cut, kRadius);
    for (int i = 0; i < 200; ++i) {
      const Vec2 p{random.between(-2, 42), random.between(-2, 42)};
      const double radius = random.between(0.1, 4);
      const bool clear = is_cleared(material, p, radius);
      cleared += clear;
      if (!cells.holds(p, radius)) continue;
      ++known;
      EXPECT_TRUE(clear) << "run " << run << " at " << p.x << ' ' << p.y << " radius " << radius;
    }
  }
  EXPECT_GT(cleared, 1000);
  EXPECT_GT(known, 0.6 * cleared);
}

TEST(ClearedCells, TellTheSameAfterATrialIsTakenBack) {
  Random random(5);
  for (int run = 0; run < 20; ++run) {
    const auto cuts = random_cuts(random);
    ClearedCells cells(Box{{0, 0}, {40, 40}}, kRadius / 8), fresh = cells;
    const std::size_t kept = cuts.size() / 2;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      cells.add(cuts[i], kRadius);
      if (i < kept) fresh.add(cuts[i], kRadius);
    }
    if (run % 2 == 0) cells.holds({20, 20}, 1);  // marks them all
    cells.forget_beyond(kept);
    EXPECT_EQ(cells.cuts(), kept);
    for (int i = 0; i < 200; ++i) {
      const Vec2 p{random.between(0, 40), random.between(0, 40)};
      EXPECT_EQ(cells.holds(p, 1), fresh.holds(p, 1));
    }
  }
}

TEST(ClearedCells, KnowNothingOutside) {
  ClearedCells cells(Box{{0, 0}, {10, 10}}, 0.5);
  cells.add(Edge::line({5, 5}, {5, 5}), 20);
  EXPECT_TRUE(cells.holds({5, 5}, 4));
  EXPECT_FALSE(cells.holds({5, 5}, 6));
  EXPECT_FALSE(cells.holds({-5, 5}, 0));
  EXPECT_FALSE(ClearedCells(Box{}, 1).holds({0, 0}, 0));
}

}  // namespace
}  // namespace clearcut::plan::adaptive
