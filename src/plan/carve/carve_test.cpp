// V-carving against heights found by dense sampling: what the tracks' cones leave, place by place, beside the depth that the
// distance to the outline asks for. The second method knows no medial axis: it looks at points of the tracks every 0.01 mm.
#include "plan/carve/carve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "base/units.h"
#include "geometry/voronoi/clearance.h"

namespace clearcut::plan::carve {
namespace {

constexpr int kOutlines = 1000;
constexpr int kPlaces = 60;

Loop star(Random& random, Vec2 center, double size, bool clockwise) {
  const int corners = 5 + static_cast<int>(random.below(8));
  std::vector<BulgeVertex> vertices;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * (i + 0.6 * random.unit()) / corners;
    const double bulge = random.unit() < 0.3 ? 0.25 * (random.unit() - 0.3) : 0;
    vertices.push_back({center + direction_of(angle) * (size * (0.45 + 0.55 * random.unit())), bulge});
  }
  Loop loop = loop_from_bulges(vertices);
  return clockwise ? reversed(loop) : loop;
}

/// A star with bows, every third with a smaller one in its middle.
Region outline(std::uint64_t seed) {
  Random random(seed);
  const double size = 3 + 9 * random.unit();
  Loop outer = star(random, {}, size, false);
  std::vector<Loop> islands;
  if (seed % 3 == 0) islands.push_back(star(random, {}, size * 0.12, true));
  return Region::from_valid_loops(std::move(outer), std::move(islands));
}

CarveShape shape_for(std::uint64_t seed, double widest) {
  CarveShape shape;
  shape.slope = std::tan(kPi / 180 * (seed % 2 == 0 ? 30 : 45));
  shape.tip_radius = seed % 5 == 0 ? 0.1 : 0;
  shape.aside = 0.0004;
  shape.stepdown = 1.5;
  shape.cusp = 0.03;
  // Half of them reach a floor.
  shape.floor = -(widest / shape.slope) * (seed % 4 < 2 ? 1.0 : 0.8);
  return shape;
}

/// Lowest that cones at points of the tracks leave p.
double height_left(const TrackSets& sets, const CarveShape& shape, Vec2 p) {
  double lowest = HUGE_VAL;
  for (const auto& set : sets) {
    for (const Track& track : set) {
      for (const Track::Piece& piece : track.pieces) {
        const double length = piece.path.from == piece.path.to ? 0 : piece.path.length();
        const double low = std::min(piece.z_from, piece.z_to);
        const double near =
            piece.path.from == piece.path.to ? distance(piece.path.from, p) : distance(piece.path, p);
        if (low + std::max(0.0, near - shape.tip_radius) / shape.slope >= lowest) continue;
        const int steps = 1 + static_cast<int>(length / 0.01);
        for (int i = 0; i <= steps; ++i) {
          const double t = static_cast<double>(i) / steps;
          const Vec2 at = length > 0 ? piece.path.at(t) : piece.path.from;
          const double z = piece.z_from + (piece.z_to - piece.z_from) * t;
          lowest = std::min(lowest, z + std::max(0.0, distance(at, p) - shape.tip_radius) / shape.slope);
        }
      }
    }
  }
  return lowest;
}

TEST(Carve, EveryPlaceIsAsDeepAsItsDistanceToTheOutlineAsks) {
  const Tolerances tol;
  double too_deep = 0, too_high = 0;
  for (std::uint64_t seed = 1; seed <= kOutlines; ++seed) {
    const Region region = outline(seed);
    const double widest = Clearance(region, tol).max();
    const CarveShape shape = shape_for(seed, widest);
    const TrackSets sets = carve_region(region, shape, {}, tol);
    ASSERT_FALSE(sets.empty()) << "outline " << seed;
    Random random(seed + 77777);
    const Box box = region.box();
    for (int i = 0; i < kPlaces; ++i) {
      const Vec2 p{box.min.x + box.width() * random.unit(), box.min.y + box.height() * random.unit()};
      if (!region.contains(p)) continue;
      const double from_outline = region.boundary_distance(p);
      const double asked = std::max(shape.floor, shape.top - from_outline / shape.slope);
      const double left = height_left(sets, shape, p);
      too_deep = std::max(too_deep, (asked - left) * shape.slope);
      // A flat tip is as wide as it is, and a floor has cusps.
      const double tip = shape.tip_radius / shape.slope;
      const bool near_floor = asked < shape.floor + shape.cusp + tip;
      const double spare = tip + (near_floor ? shape.cusp : 0);
      too_high = std::max(too_high, left - asked - spare);
      ASSERT_LT((asked - left) * shape.slope, 0.001) << "outline " << seed << " at " << p.x << " " << p.y;
      ASSERT_LT(left - asked - spare, 0.01) << "outline " << seed << " at " << p.x << " " << p.y;
    }
  }
  RecordProperty("too_deep_um", std::to_string(too_deep * 1000));
  RecordProperty("too_high_um", std::to_string(too_high * 1000));
}

TEST(Carve, SharpCornersAreCutUpToTheirTips) {
  const Tolerances tol;
  const Region square =
      Region::from_valid_loops(loop_from_points(std::vector<Vec2>{{0, 0}, {6, 0}, {6, 6}, {0, 6}}), {});
  CarveShape shape;
  shape.slope = std::tan(kPi / 6);
  shape.floor = -3 / shape.slope;
  shape.stepdown = 10;
  const TrackSets sets = carve_region(square, shape, {}, tol);
  for (const Vec2 corner : {Vec2{0, 0}, Vec2{6, 0}, Vec2{6, 6}, Vec2{0, 6}}) {
    double nearest_end = HUGE_VAL;
    for (const auto& set : sets)
      for (const Track& track : set)
        for (const Track::Piece& piece : track.pieces)
          nearest_end =
              std::min({nearest_end, distance(piece.path.from, corner), distance(piece.path.to, corner)});
    EXPECT_LT(nearest_end, 1e-6);
  }
}

TEST(Carve, NoPassGoesDeeperAtOnceThanTheStepdown) {
  const Tolerances tol;
  const Region region = outline(4);
  CarveShape shape = shape_for(4, Clearance(region, tol).max());
  shape.stepdown = 0.7;
  const TrackSets sets = carve_region(region, shape, {}, tol);
  double before = shape.top;
  for (const auto& set : sets) {
    double low = before;
    for (const Track& track : set)
      for (const Track::Piece& piece : track.pieces) low = std::min({low, piece.z_from, piece.z_to});
    EXPECT_GE(low, before - 0.7 - 1e-9);
    before = low;
  }
}

/// Which corner of a square about the origin a track lies in.
int corner_of(const Track& track) {
  const Vec2 p = track.pieces[track.pieces.size() / 2].path.at(0.5);
  return (p.x > 0 ? 1 : 0) + (p.y > 0 ? 2 : 0);
}

TEST(Carve, CornersThatAMillLeftAreClearedOneAfterTheOther) {
  const Tolerances tol;
  const Region whole = Region::from_valid_loops(
      loop_from_points(std::vector<Vec2>{{-10, -10}, {10, -10}, {10, 10}, {-10, 10}}), {});
  // What a mill of 6 mm clears of the floor: all but its four corners.
  const double quarter = std::tan(kPi / 8);
  const std::vector<BulgeVertex> rounded{{{-6, -9}, 0},     {{6, -9}, quarter}, {{9, -6}, 0},
                                         {{9, 6}, quarter}, {{6, 9}, 0},        {{-6, 9}, quarter},
                                         {{-9, 6}, 0},      {{-9, -6}, quarter}};
  const Regions cleared{Region::from_valid_loops(loop_from_bulges(rounded), {})};
  CarveShape shape;
  shape.slope = 0.5;
  shape.floor = -2;
  shape.stepdown = 5;
  shape.cusp = 0.1;
  const TrackSets sets = carve_region(whole, shape, cleared, tol);
  ASSERT_GT(sets.size(), 8u);
  std::vector<int> corners;
  for (std::size_t i = 1; i < sets.size(); ++i)
    for (const Track& track : sets[i])
      if (corners.empty() || corners.back() != corner_of(track)) corners.push_back(corner_of(track));
  EXPECT_EQ(corners.size(), 4u);
}

TEST(Carve, NoTrackStepsOverWhatIsOnlyRounding) {
  const Tolerances tol;
  int steps = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Region region = outline(seed);
    for (const auto& set : carve_region(region, shape_for(seed, Clearance(region, tol).max()), {}, tol))
      for (const Track& track : set)
        for (const Track::Piece& piece : track.pieces)
          if (track.pieces.size() > 1 && !track.closed && piece.path.length() < 0.0001) ++steps;
  }
  EXPECT_EQ(steps, 0);
}

TEST(Carve, ACircleIsOnePlunge) {
  const Tolerances tol;
  const std::vector<BulgeVertex> circle{{{2, 0}, 1}, {{-2, 0}, 1}};
  CarveShape shape;
  shape.slope = 1;
  shape.floor = -2;
  shape.stepdown = 5;
  const TrackSets sets = carve_region(Region::from_valid_loops(loop_from_bulges(circle), {}), shape, {}, tol);
  ASSERT_EQ(sets.size(), 1u);
  ASSERT_EQ(sets[0].size(), 1u);
  EXPECT_NEAR(sets[0][0].pieces[0].z_from, -2, 1e-6);
  EXPECT_LT(norm(sets[0][0].pieces[0].path.from), 1e-6);
}

}  // namespace
}  // namespace clearcut::plan::carve
