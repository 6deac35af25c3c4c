// Two methods to find the next contour that share nothing: the papers' bookkeeping of lengths and angles, and the geometric
// offsets of the kernel.
//
// Convex outlines, with and without arcs: both must agree in every side, arc and corner, down to the centre, through
// sides that vanish singly and in runs. Concave outlines with arcs about reflex corners: they must agree until a side
// at a reflex corner vanishes or the contour splits, which the bookkeeping cannot know. Mitred reflex corners have no
// geometric twin here: their sides are those of the rounded ones, longer by H |cot(alpha / 2)| at each reflex end.
#include "plan/contour/side_offsets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "geometry/voronoi/clearance.h"
#include "plan/contour/contour.h"

namespace clearcut::plan::contour {
namespace {

const Tolerances kTol;
/// mm. The kernel promises 1 um.
constexpr double kSame = 0.003;

SideList list_of(const std::vector<Vec2>& corners, const std::vector<double>& radii = {}) {
  const Loop loop = loop_from_points(corners);
  SideList list;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 in = loop[i].tangent_at(1), out = loop[(i + 1) % loop.size()].tangent_at(0);
    const double radius = radii.empty() ? 0 : radii[i];
    list.sides.push_back({loop[i].length(), kPi - std::atan2(cross(in, out), dot(in, out)), radius});
  }
  for (std::size_t i = 0; i < loop.size(); ++i) {
    list.sides[i].length -= tangent_length(list.sides[(i + loop.size() - 1) % loop.size()]);
    list.sides[i].length -= tangent_length(list.sides[i]);
  }
  const Vec2 along = loop[0].tangent_at(0);
  list.orientation = std::atan2(along.y, along.x);
  list.start = corners[0] + along * tangent_length(list.sides.back());
  return list;
}

Region region_of(const SideList& list) {
  return Region::from_valid_loops(closed_by_compass_rule(traced(list)), {});
}

/// Greatest distance from the loop to the edges of the other.
double apart(const Loop& loop, const Loop& other) {
  double most = 0;
  for (const auto& edge : loop) {
    for (const double t : {0.0, 0.25, 0.5, 0.75}) {
      double nearest_distance = 1e9;
      for (const auto& candidate : other)
        nearest_distance = std::min(nearest_distance, distance(candidate, edge.at(t)));
      most = std::max(most, nearest_distance);
    }
  }
  return most;
}

/// The contour as the kernel has it, when it is one loop.
const Loop* single_loop(const Regions& regions) {
  return regions.size() == 1 && regions[0].islands().empty() ? &regions[0].outer() : nullptr;
}

void expect_same(const SideList& ours, const Loop& theirs, const std::string& what) {
  const Path trace = traced(ours);
  EXPECT_LT(norm(closing_error(trace)), 1e-6) << what;
  const Loop loop = closed_by_compass_rule(trace);
  EXPECT_LT(apart(loop, theirs), kSame) << what;
  EXPECT_LT(apart(theirs, loop), kSame) << what;
  EXPECT_NEAR(length_of(ours), length(theirs), 0.02) << what;
}

std::vector<Vec2> random_convex(Random& random) {
  std::vector<double> angles;
  const std::size_t n = 3 + random.below(10);
  for (std::size_t i = 0; i < n; ++i) angles.push_back(random.between(0, 2 * kPi));
  std::sort(angles.begin(), angles.end());
  const double a = random.between(20, 60), b = random.between(20, 60);
  std::vector<Vec2> corners;
  for (const double angle : angles) corners.push_back({a * std::cos(angle), b * std::sin(angle)});
  return corners;
}

TEST(SideOffsets, ConvexOutlinesAgreeDownToTheCentre) {
  int contours = 0, vanished = 0, runs = 0, gone = 0;
  for (int seed = 0; seed < 400; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const SideList list = list_of(random_convex(random));
    const Region region = region_of(list);
    const Clearance clearance(region, kTol);
    if (clearance.max() < 0.5) continue;
    const double step = clearance.max() * random.between(0.1, 0.6);
    auto next = offset_sides(list, step, ReflexCorners::kMitred);
    for (double level = step; next.end == SideOffsetEnd::kContour && level < clearance.max() - 0.05;
         level += step) {
      const auto regions = clearance.inset(level);
      const Loop* theirs = single_loop(regions);
      ASSERT_NE(theirs, nullptr) << seed;
      expect_same(next.contour, *theirs, "seed " + std::to_string(seed) + " level " + std::to_string(level));
      ++contours;
      vanished += next.vanished;
      runs += next.vanished > 1;
      next = offset_sides(next.contour, step, ReflexCorners::kMitred);
      if (level + step > clearance.max() + 0.001) {
        EXPECT_EQ(next.end, SideOffsetEnd::kGone) << seed;
        ++gone;
      }
    }
    EXPECT_NE(next.end, SideOffsetEnd::kBeyond) << seed;
  }
  EXPECT_GT(contours, 600);
  EXPECT_GT(vanished, 300);
  EXPECT_GT(runs, 50);
  EXPECT_GT(gone, 200);
}

/// CPO-rho appendix B: arcs shrink with the contour until they are corners.
TEST(SideOffsets, ArcsShrinkToCorners) {
  int arcs = 0, corners = 0;
  for (int seed = 0; seed < 300; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const double width = random.between(40, 90), height = random.between(40, 90),
                 lean = random.between(0, 15);
    const SideList list = list_of({{0, 0}, {width, 0}, {width + lean, height}, {lean, height}},
                                  {random.between(1, 15), random.between(1, 15), 0, random.between(1, 15)});
    const Clearance clearance(region_of(list), kTol);
    for (const double level : {random.between(0.5, 6), random.between(6, 14)}) {
      const auto next = offset_sides(list, level, ReflexCorners::kMitred);
      ASSERT_EQ(next.end, SideOffsetEnd::kContour) << seed;
      const auto regions = clearance.inset(level);
      const Loop* theirs = single_loop(regions);
      ASSERT_NE(theirs, nullptr);
      expect_same(next.contour, *theirs, "seed " + std::to_string(seed) + " level " + std::to_string(level));
      for (std::size_t i = 0; i < 4; ++i) {
        if (list.sides[i].radius > 0) (next.contour.sides[i].radius > 0 ? arcs : corners)++;
      }
    }
  }
  EXPECT_GT(arcs, 300);
  EXPECT_GT(corners, 300);
}

std::vector<Vec2> random_star(Random& random) {
  std::vector<Vec2> corners;
  const int n = 4 + static_cast<int>(random.below(8));
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * kPi * (i + random.between(0.25, 0.75)) / n, radius = random.between(30, 80);
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return corners;
}

TEST(SideOffsets, ConcaveOutlinesAgreeWhileTheBookkeepingHolds) {
  int compared = 0, reflex = 0, vanished = 0, beyond = 0, split = 0;
  for (int seed = 0; seed < 400; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    SideList list = list_of(random_star(random));
    const Clearance clearance(region_of(list), kTol);
    const double step = random.between(0.5, 3);
    for (double level = step; level < clearance.max() - 0.05; level += step) {
      const auto next = offset_sides(list, step, ReflexCorners::kRounded);
      if (next.end != SideOffsetEnd::kContour) {
        ++beyond;
        EXPECT_EQ(next.end, SideOffsetEnd::kBeyond) << seed;
        break;
      }
      const auto regions = clearance.inset(level);
      const Loop* theirs = single_loop(regions);
      // A contour that splits, or has lost a side to an arc that came from afar.
      if (!theirs || theirs->size() != traced(next.contour).size()) {
        ++split;
        break;
      }
      expect_same(next.contour, *theirs, "seed " + std::to_string(seed) + " level " + std::to_string(level));
      list = next.contour;
      ++compared;
      vanished += next.vanished;
      reflex += std::any_of(list.sides.begin(), list.sides.end(),
                            [](const Side& side) { return side.angle > kPi; });
      if (::testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(compared, 800);
  EXPECT_GT(reflex, 500);
  EXPECT_GT(vanished, 30);
  EXPECT_GT(beyond + split, 50);
}

TEST(SideOffsets, MitredSidesAreLongerByTheMitre) {
  for (int seed = 0; seed < 200; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const SideList list = list_of(random_star(random));
    const auto mitred = offset_sides(list, 1, ReflexCorners::kMitred);
    const auto rounded = offset_sides(list, 1, ReflexCorners::kRounded);
    if (mitred.end != SideOffsetEnd::kContour || rounded.end != SideOffsetEnd::kContour ||
        mitred.vanished > 0)
      continue;
    const std::size_t n = list.sides.size();
    for (std::size_t j = 0; j < n; ++j) {
      double mitre = 0;
      for (const Side& corner : {list.sides[j], list.sides[(j + n - 1) % n]}) {
        if (corner.angle > kPi) mitre -= 1 / std::tan(corner.angle / 2);
      }
      EXPECT_NEAR(mitred.contour.sides[j].length, rounded.contour.sides[j].length + mitre, 1e-9);
    }
  }
}

/// 121 and 121 degrees merge into 62 when the side between them vanishes (CPO-kappa alg. 2).
TEST(SideOffsets, TwoAnglesBecomeOne) {
  const double lean = 31 * kPi / 180;
  const Vec2 b{8, 0};
  const SideList list = list_of({{0, 0},
                                 b,
                                 b + Vec2{std::sin(lean), std::cos(lean)} * 120,
                                 Vec2{-std::sin(lean), std::cos(lean)} * 120});
  EXPECT_NEAR(list.sides[0].angle * 180 / kPi, 121, 1e-9);
  const auto next = offset_sides(list, 10, ReflexCorners::kMitred);
  ASSERT_EQ(next.end, SideOffsetEnd::kContour);
  EXPECT_EQ(next.vanished, 1);
  EXPECT_NEAR(smallest_angle(next.contour) * 180 / kPi, 59, 1e-9);
  const bool merged = std::any_of(next.contour.sides.begin(), next.contour.sides.end(), [](const Side& side) {
    return std::abs(side.angle * 180 / kPi - 62) < 1e-9;
  });
  EXPECT_TRUE(merged);
}

/// A cut corner vanishes, whatever side comes first, and arcs smaller than the step leave nothing in the contour (CPO-rho appendix B).
TEST(SideOffsets, ACornerThatWasCutIsSharpFartherIn) {
  const std::vector<Vec2> outline{{0, 0}, {60, 0}, {60, 35}, {55, 40}, {0, 40}};
  const std::vector<Vec2> inside{{10, 10}, {50, 10}, {50, 30}, {10, 30}};
  for (std::size_t first = 0; first < outline.size(); ++first) {
    for (const bool with_arcs : {false, true}) {
      std::vector<Vec2> corners = outline;
      std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(first), corners.end());
      std::vector<double> radii;
      for (std::size_t j = 0; j < corners.size(); ++j) radii.push_back(with_arcs ? 1 + 0.25 * j : 0);
      const auto next = offset_sides(list_of(corners, radii), 10, ReflexCorners::kMitred);
      ASSERT_EQ(next.end, SideOffsetEnd::kContour);
      EXPECT_EQ(next.vanished, 1);
      const Path path = traced(next.contour);
      ASSERT_EQ(path.size(), 4U);
      for (const Edge& edge : path) {
        EXPECT_TRUE(std::any_of(inside.begin(), inside.end(),
                                [&](Vec2 corner) { return norm(edge.from - corner) < 1e-9; }))
            << first << ": " << edge.from.x << ", " << edge.from.y;
      }
      EXPECT_LT(norm(closing_error(path)), 1e-9);
    }
  }
}

/// CPO-kappa figure 10, from the formulas alone.
TEST(SideOffsets, TheTriangleOfTheResultFile) {
  SideList list;
  for (int i = 0; i < 3; ++i) list.sides.push_back({79.9861, kPi / 3, 0});
  const auto path = published_length(list, 5, 0, [](double) { return 7.01; });
  ASSERT_EQ(path.contours.size(), 3u);
  EXPECT_NEAR(path.contours[0].start.x, 8.6603, 5e-5);
  EXPECT_NEAR(path.contours[0].start.y, 5, 1e-9);
  EXPECT_NEAR(path.contours[0].start.x + path.contours[0].sides[0].length, 71.3259, 1e-4);
  EXPECT_NEAR(path.passages, 2 * 14.02, 1e-9);
  EXPECT_NEAR(path.total, 373.4802, 5e-4);
  EXPECT_FALSE(path.beyond);
}

}  // namespace
}  // namespace clearcut::plan::contour
