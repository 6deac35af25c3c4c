// Lower bounds of lengths: recomputed point by point with rasters, and below the lengths of paths known to clear.
#include "verify/coverage/length_bound.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/random.h"
#include "base/units.h"
#include "geometry/contours/boolean.h"
#include "verify/test_program.h"

namespace clearcut::verify {
namespace {

using testing::circle_loop;
using testing::rectangle;

/// Boxes joined in a row, with thin arms: places where points and rings count.
Regions random_area(Random& random) {
  Regions area = rectangle(0, 0, random.between(2, 5), random.between(1, 4));
  for (int i = 0; i < 4; ++i) {
    const double x = random.between(0, 4), y = random.between(0, 3);
    const bool lies = random.below(2) == 0;
    const double length = random.between(1, 6), width = random.between(0.3, 1.5);
    area = unite(area, rectangle(x, y, x + (lies ? length : width), y + (lies ? width : length)), {});
  }
  return area;
}

bool is_on_boundary(const Regions& area, Vec2 p) {
  for (const Edge& edge : edges_of(area))
    if (distance(edge, p) < 1e-9) return true;
  return false;
}

/// Whether p belongs to the cell of point i.
bool is_in_cell(const LengthBound& bound, std::size_t i, Vec2 p) {
  const double radius = bound.cutter_radius_mm;
  const Vec2 v = bound.points[i].at;
  for (const LengthBoundPoint& other : bound.points)
    if (other.at != v && distance(p, other.at) < distance(p, v)) return false;
  for (const LengthBoundRing& ring : bound.rings)
    if (dot(p - ring.at, unit(v - ring.at)) < ring.radius_mm + radius) return false;
  return true;
}

/// mm2; the share of point i, from rasters of places and centers.
double share_by_raster(const Regions& area, const LengthBound& bound, std::size_t i, int side) {
  const double radius = bound.cutter_radius_mm, pitch = 4 * radius / side;
  const Vec2 v = bound.points[i].at;
  std::vector<Vec2> outside;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const Vec2 p = v + Vec2{(column + 0.5) * pitch - 2 * radius, (row + 0.5) * pitch - 2 * radius};
      if (is_in_cell(bound, i, p) && !contains(area, p)) outside.push_back(p);
    }
  }
  double least = 1e300;
  for (int row = -12; row <= 12; ++row) {
    for (int column = -12; column <= 12; ++column) {
      const Vec2 center = v + radius / 12 * Vec2{1.0 * column, 1.0 * row};
      if (distance(center, v) > radius) continue;
      double sum = 0;
      for (const Vec2 p : outside) sum += distance(p, center) < radius ? pitch * pitch : 0;
      least = std::min(least, sum);
    }
  }
  return least;
}

double area_by_raster(const Regions& area, Vec2 center, double radius, int side) {
  const double pitch = 2 * radius / side;
  const Vec2 across = unit({2, 1});  // not along walls
  double sum = 0;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const Vec2 p = center + ((column + 0.5) * pitch - radius) * across +
                     ((row + 0.5) * pitch - radius) * left_of(across);
      if (distance(p, center) < radius && contains(area, p)) sum += pitch * pitch;
    }
  }
  return sum;
}

TEST(LengthBound, ItsPointsAndRingsAreRightByRasters) {
  const char* const asked = std::getenv("CLEARCUT_LENGTH_BOUNDS");
  const int rounds = asked != nullptr ? std::atoi(asked) : 4;
  Random random(17);
  std::size_t rings = 0, points = 0;
  for (int round = 0; round < rounds; ++round) {
    const Regions area = random_area(random);
    if (area.size() != 1) continue;
    const bool closed = round % 2 == 0;
    const LengthBound bound = length_bound({area, 0.5, closed, 1, 0});
    for (std::size_t i = 0; i < bound.points.size(); ++i) {
      const double share = share_by_raster(area, bound, i, 60);
      EXPECT_LE(bound.points[i].mm2, share + 0.02) << round << " point " << i;
      EXPECT_TRUE(is_on_boundary(area, bound.points[i].at)) << round << " point " << i;
    }
    for (std::size_t i = 0; i < bound.rings.size(); ++i) {
      const LengthBoundRing& ring = bound.rings[i];
      EXPECT_NEAR(ring.mm2, area_by_raster(area, ring.at, ring.radius_mm + 0.5, 200), 0.02 * ring.mm2)
          << round;
      for (std::size_t k = 0; k < i; ++k)
        EXPECT_GE(distance(ring.at, bound.rings[k].at), ring.radius_mm + bound.rings[k].radius_mm - 1e-9);
    }
    EXPECT_NEAR(bound.area_mm2, geometry::area(area), 1e-9);
    EXPECT_EQ(bound.mm, added_up(bound));
    points += bound.points.size();
    rings += bound.rings.size();
  }
  EXPECT_GT(points, 0u);
  EXPECT_GT(rings, 0u);
}

TEST(LengthBound, SquareHasFourCorners) {
  const Regions square = rectangle(0, 0, 10, 10);
  // A disc through a right corner has two segments outside, R sin 45 from its center.
  const double segments = 2 * 0.25 * (kPi / 4 - 0.5);
  const LengthBound closed = length_bound({square, 0.5, true, 1, 0});
  EXPECT_EQ(closed.points.size(), 4u);
  EXPECT_LE(closed.mm, 100 + 4 * segments);
  EXPECT_GE(closed.mm, 100 + 4 * (segments - 0.01 * 0.25));
  EXPECT_NEAR(length_bound({square, 0.5, false, 1, 0}).mm, closed.mm - kPi / 4, 1e-9);
  EXPECT_NEAR(length_bound({square, 0.5, false, 2, 0}).mm, closed.mm - kPi / 2, 1e-9);
  // Where some may be left, it may be the corners.
  EXPECT_NEAR(length_bound({square, 0.5, false, 1, 0.5}).mm, 99.5 - kPi / 4, 1e-9);
}

TEST(LengthBound, IsSharpForDiscsAndStadiums) {
  const Regions disc{Region::from_valid_loops(circle_loop({0, 0}, 3), {})};
  // Closed: the circle of radius 2 R - R clears a disc of radius 2 R exactly.
  EXPECT_LE(length_bound({disc, 1.5, true, 1, 0}).mm, 2 * kPi * 1.5 + 1e-9);
  EXPECT_GE(length_bound({disc, 1.5, true, 1, 0}).mm, 2 * kPi * 1.5 - 0.05);
  // One place clears a disc no larger than the cutter.
  EXPECT_LE(length_bound({disc, 3, false, 1, 0}).mm, 1e-9);
  EXPECT_LE(length_bound({disc, 3, true, 1, 0}).mm, 1e-9);
  EXPECT_EQ(length_bound({{}, 3, true, 1, 0}).mm, 0);
}

TEST(LengthBound, CountsArmsTwiceForToursThatReturn) {
  // A room and an arm 0.4 wide and 8 long: a tour goes in and out.
  const Regions area = unite(rectangle(0, 0, 6, 6), rectangle(6, 3, 14, 3.4), {});
  const LengthBound tour = length_bound({area, 0.5, true, 1, 0});
  EXPECT_FALSE(tour.rings.empty());
  EXPECT_GT(tour.mm, 36 + 11);
  // Along the room, then into the arm and out again.
  EXPECT_LT(tour.mm, 36 + 6 + 2 * 8);
  EXPECT_LE(length_bound({area, 0.5, false, 1, 0}).mm, 36 + 6 + 8);
}

TEST(LengthBound, CountsPlacesFarFromOneAnother) {
  // Two rooms 0.1 wide, 20 apart: a path goes from one to the other, a tour there and back.
  const Regions rooms = unite(rectangle(0, 0, 0.1, 0.1), rectangle(20, 0, 20.1, 0.1), {});
  const double path = length_bound({rooms, 0.5, false, 1, 0}).mm,
               tour = length_bound({rooms, 0.5, true, 1, 0}).mm;
  EXPECT_LE(path, 19.1);
  EXPECT_LE(tour, 38.2);
  EXPECT_GT(tour, 25);
  EXPECT_GT(path, 10);
}

}  // namespace
}  // namespace clearcut::verify
