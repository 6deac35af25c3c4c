#include "plan/common/round_corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "base/random.h"
#include "geometry/edge.h"
#include "geometry/region.h"

namespace clearcut::plan {
namespace {

constexpr double kRadius = 3;

LegalArea everywhere() {
  return LegalArea({rectangular_region({{-100, -100}, {200, 200}})});
}

Pass pass_along(const std::vector<Vec2>& points) {
  Pass pass;
  pass.path = line_path(points);
  return pass;
}

double length_of(const std::vector<Pass>& passes) {
  double sum = 0;
  for (const Pass& pass : passes) sum += length(pass.path);
  return sum;
}

double distance_to(const std::vector<Pass>& passes, Vec2 p) {
  double least = 1e9;
  for (const Pass& pass : passes)
    for (const Edge& edge : pass.path) least = std::min(least, distance(edge, p));
  return least;
}

TEST(RoundCorners, ACornerThatNothingElseClearsStays) {
  const LegalArea legal = everywhere();
  std::vector<Pass> passes{pass_along({{0, 0}, {20, 0}, {20, 20}})};
  round_corners(passes, {kRadius, kRadius, &legal});
  EXPECT_EQ(passes.front().path.size(), 2U);
}

TEST(RoundCorners, ACornerWhosePlaceAnotherPassClearsBecomesATangentialArc) {
  const LegalArea legal = everywhere();
  std::vector<Pass> passes{pass_along({{0, 0}, {20, 0}, {20, 20}}),
                           pass_along({{-5, -4}, {24, -4}, {24, 25}})};
  const double before = length_of(passes);
  round_corners(passes, {kRadius, kRadius, &legal});
  const Path& path = passes.front().path;
  ASSERT_EQ(path.size(), 3U);
  EXPECT_TRUE(path[1].is_arc());
  EXPECT_GT(path[1].radius(), 1);
  EXPECT_NEAR(dot(path[0].tangent_at(1), path[1].tangent_at(0)), 1, 1e-12);
  EXPECT_NEAR(dot(path[1].tangent_at(1), path[2].tangent_at(0)), 1, 1e-12);
  EXPECT_LT(length_of(passes), before);
}

TEST(RoundCorners, AnArcThatWouldLeaveTheLegalAreaIsNotMade) {
  // An island stands inside the corner.
  const std::vector<Vec2> corners{{17.5, 3}, {19.5, 3}, {19.5, 1}, {17.5, 1}};
  const Loop island = loop_from_points(corners);
  const LegalArea legal(
      {Region::from_valid_loops(rectangular_region({{-100, -100}, {200, 200}}).outer(), {island})});
  std::vector<Pass> passes{pass_along({{0, 0}, {20, 0}, {20, 20}}),
                           pass_along({{-5, -4}, {24, -4}, {24, 25}})};
  round_corners(passes, {kRadius, kRadius, &legal});
  for (const Edge& edge : passes.front().path)
    for (int i = 0; i <= 50; ++i) EXPECT_TRUE(legal.holds(edge.at(i / 50.0)));
}

TEST(RoundCorners, ACornerThatCostsNoTimeStays) {
  const LegalArea legal = everywhere();
  const auto moves = [&](double speed) {
    std::vector<Pass> passes{pass_along({{0, 0}, {20, 0}, {40, 2}}),
                             pass_along({{-5, -4}, {24, -4}, {44, -2}})};
    round_corners(passes, {kRadius, kRadius, &legal, speed, 500});
    return passes.front().path.size();
  };
  EXPECT_EQ(moves(5), 2U);
  EXPECT_EQ(moves(50), 3U);
}

/// What lay within the radius of some pass still does: sampled, so that slivers under the samples' distance are not seen.
TEST(RoundCorners, NothingThatWasClearedIsLeft) {
  const LegalArea legal = everywhere();
  Random random(5);
  std::size_t rounded = 0;
  const char* asked = std::getenv("CLEARCUT_RANDOM_CORNERS");
  const int rounds = asked ? std::atoi(asked) : 60;
  for (int round = 0; round < rounds; ++round) {
    std::vector<Pass> passes;
    for (int k = 0; k < 3; ++k) {
      std::vector<Vec2> points;
      for (int i = 0; i < 8; ++i) points.push_back({30 * random.between(0, 1), 30 * random.between(0, 1)});
      passes.push_back(pass_along(points));
    }
    const std::vector<Pass> before = passes;
    round_corners(passes, {kRadius, kRadius, &legal});
    EXPECT_LE(length_of(passes), length_of(before));
    for (const Pass& pass : passes) {
      rounded += pass.path.size();
      for (std::size_t i = 1; i < pass.path.size(); ++i) EXPECT_EQ(pass.path[i - 1].to, pass.path[i].from);
    }
    for (int i = 0; i < 1500; ++i) {
      const Vec2 p{40 * random.between(0, 1) - 5, 40 * random.between(0, 1) - 5};
      if (distance_to(before, p) > kRadius) continue;
      EXPECT_LE(distance_to(passes, p), kRadius + 1e-6) << round << " at " << p.x << ", " << p.y;
    }
  }
  EXPECT_GT(rounded, static_cast<std::size_t>(rounds) * (3U * 7U + 1U));
}

}  // namespace
}  // namespace clearcut::plan
