#include "geometry/opened_area.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "base/units.h"
#include "geometry/voronoi/clearance.h"

namespace clearcut::inline geometry {
namespace {

/// A polygon about `center` with corners at random distances of `least` to 1 times `size`.
Loop star(Random& random, Vec2 center, double size, double least) {
  std::vector<Vec2> points;
  const int count = 3 + static_cast<int>(random.below(9));
  for (int i = 0; i < count; ++i)
    points.push_back(center + direction_of(2 * kPi * i / count) * (size * random.between(least, 1)));
  return loop_from_points(points);
}

TEST(OpenedArea, IsThatOfTheDilatedInset) {
  const Tolerances tol;
  Random random(7);
  int exact = 0, other = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<Loop> islands;
    if (i % 2 == 1) islands.push_back(star(random, {random.between(-1.5, 1.5), 0}, 2, 0.5));
    const Region region = Region::from_valid_loops(star(random, {}, 30, 0.3), islands);
    const double d = random.between(0.3, 6);
    const Regions inside = inset(region, d, tol);
    if (inside.empty()) continue;
    const double bound = area_within(inside, d), reached = area(dilate(inside, d, tol));
    EXPECT_GE(bound, reached - 1e-3) << i;  // dilated pieces are united
    if (is_opened_at_corners_only(region, inside)) {
      EXPECT_NEAR(bound, reached, 1e-6) << i;
      ++exact;
    } else {
      ++other;
    }
  }
  EXPECT_GT(exact, 100);
  EXPECT_GT(other, 10);
}

}  // namespace
}  // namespace clearcut::inline geometry
