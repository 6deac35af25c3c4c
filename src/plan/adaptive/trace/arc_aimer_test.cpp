#include "plan/adaptive/trace/arc_aimer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "base/units.h"

namespace clearcut::plan::adaptive {
namespace {

constexpr double kTool = 5;

/// A square pocket whose middle is cleared up to `cleared` mm.
struct ClearedPocket {
  explicit ClearedPocket(double cleared) : remaining(area, kTool, std::nullopt) {
    remaining.remove_disc({25, 25}, cleared);
  }

  Regions area = {
      Region::from_valid_loops(loop_from_points(std::vector<Vec2>{{5, 5}, {45, 5}, {45, 45}, {5, 45}}), {})};
  RemainingStock remaining;
};

/// Along the lower wall, x mm from its beginning.
CutterState on_wall(double x, double limit) {
  return {{5 + x, 5}, {1, 0}, 1 / kTool, limit, kTool, kTool / 2, 0.0};
}

/// The largest engagement and what is lost, sampled closely.
struct Samples {
  double most = 0;
  double lost = 0;
};
Samples sample_along(const CutterState& from, const CandidateArc& candidate, const RemainingStock& remaining,
                     double limit) {
  constexpr int kSamples = 2000;
  Samples samples;
  for (int k = 0; k < kSamples; ++k) {
    const auto [p, heading] = after(from, candidate, candidate.length * (k + 0.5) / kSamples);
    const double engagement = remaining.engagement(p, heading);
    samples.most = std::max(samples.most, engagement);
    samples.lost +=
        std::max(0.0, 1 - (1 - std::cos(engagement)) / (1 - std::cos(limit))) * candidate.length / kSamples;
  }
  return samples;
}

TEST(ArcAimer, CrossesACornerOnOneArcWithinTheLimitAndSaysWhatThatLoses) {
  Random random(3);
  int crossings = 0, sure_ones = 0;
  for (int i = 0; i < 400; ++i) {
    const double limit = random.between(0.7, 1.5);
    ClearedPocket pocket(random.between(24, 30));
    const ArcAimer aimer(pocket.remaining, pocket.area, limit);
    const CutterState from = on_wall(random.between(20, 38), limit);
    pocket.remaining.cut(Edge::line({5, 5}, from.point));
    const auto crossing = aimer.across(from, 0.5 / kTool);
    if (!crossing || !aimer.leaves_wall(from, crossing->candidate)) continue;
    ++crossings;
    SCOPED_TRACE(testing::Message() << "limit " << limit << " from " << from.point.x);
    const CandidateArc& candidate = crossing->candidate;
    const Samples samples = sample_along(from, candidate, pocket.remaining, limit);
    EXPECT_NEAR(crossing->lost, samples.lost, 0.08 * candidate.length);
    EXPECT_TRUE(crossing->loses_little() ? samples.lost < 0.19 * candidate.length
                                         : samples.lost > 0.03 * candidate.length);
    EXPECT_NEAR(after(from, candidate, candidate.length).point.x, 45, 1e-6) << "it ends on the wall";
    const auto sure = aimer.surely_within(from, candidate);
    if (!sure) continue;
    ++sure_ones;
    EXPECT_LE(sample_along(from, *sure, pocket.remaining, limit).most,
              limit + EngagementTolerance::kExcess + 2e-3);
  }
  EXPECT_GT(crossings, 40);
  EXPECT_GT(sure_ones, 30);
}

TEST(ArcAimer, CrossesNothingWhereNoWallIsNear) {
  const ClearedPocket pocket(10);
  const ArcAimer aimer(pocket.remaining, pocket.area, 1.2);
  EXPECT_FALSE(aimer.across(on_wall(1, 1.2), 1 / kTool).has_value());
  EXPECT_FALSE(
      aimer.meets_wall({{25, 25}, {1, 0}, 1 / kTool, 1.2, kTool, kTool / 2, std::nullopt}, 1 / kTool));
}

TEST(ArcAimer, PlacesOnAShotAreOnItsArc) {
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const CutterState from{
        {random.between(-9, 9), random.between(-9, 9)}, direction_of(random.between(0, 6)), 0, 0, 0, 1, {}};
    const CandidateArc candidate{random.between(-0.4, 0.4), random.between(0.1, 9),
                                 random.between(-0.1, 0.1)};
    const Edge edge = edge_of(from, candidate);
    for (const double t : {0.3, 0.8, 1.0})
      EXPECT_LT(distance(after(from, candidate, t * candidate.length).point, edge.at(t)), 2e-4);
    EXPECT_GT(dot(after(from, candidate, candidate.length).heading, edge.tangent_at(1)), 1 - 1e-3);
  }
}

}  // namespace
}  // namespace clearcut::plan::adaptive
