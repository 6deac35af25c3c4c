#include "plan/common/outer_rim.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/random.h"
#include "base/units.h"
#include "plan/common/cover.h"

namespace clearcut::plan {
namespace {

/// Where the rim of a corner is proven, one straight line in place of the corner's two pieces leaves no hole.
TEST(OuterRim, WhatItProvesTheExactCheckFindsToo) {
  constexpr double kRadius = 3;
  int proven = 0, left = 0;
  for (int seed = 1; seed <= 400; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Edge first = Edge::line({-2, 0}, {0, random.between(-0.3, 0.3)}),
               second = Edge::line(first.to, {2, 0});
    std::vector<Edge> edges{Edge::line(first.from, second.to)};
    for (const double side : {-1.0, 1.0}) {
      const double aside = side * random.between(4, 6.4);
      edges.push_back(
          Edge::line({-9, aside + random.between(-0.5, 0.5)}, {9, aside + random.between(-0.5, 0.5)}));
    }
    const double deviation = distance(edges.front(), first.to) + kAtRim;
    // Places on the very rim are on that of the straight line, too, at their common ends.
    const auto was_cut = [&](Vec2 p) {
      return std::min(distance(first, p), distance(second, p)) <= kRadius - 2 * kAtRim;
    };
    const Box where = Box{first.from, second.to}.grown(kRadius + 1);
    const bool leaves = Cover(edges, kRadius, where).has_hole(where, was_cut);
    const bool is_proven = clear_outer_rim(first, second, edges, kRadius, deviation);
    EXPECT_FALSE(is_proven && leaves) << seed;
    proven += is_proven ? 1 : 0;
    left += leaves ? 1 : 0;
  }
  EXPECT_GT(proven, 50);
  EXPECT_GT(left, 50);
}

TEST(OuterRim, NobodyClearsTheCornerOfALonelyPath) {
  const Edge first = Edge::line({-2, 0}, {0, 1}), second = Edge::line({0, 1}, {2, 0});
  EXPECT_FALSE(clear_outer_rim(first, second, std::vector{Edge::line({-2, 0}, {2, 0})}, 3, 0));
}

}  // namespace
}  // namespace clearcut::plan
