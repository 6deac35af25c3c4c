#include "support/random/wide_parts.h"

#include <cmath>

#include "geometry/contours/boolean.h"
#include "support/random/random_parts.h"

namespace clearcut::test_support {
namespace {

const Tolerances kTol;

Regions area_within(const Box& box) {
  const std::vector<Vec2> corners{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  return {Region::from_valid_loops(loop_from_points(corners), {})};
}

/// On whole millimetres, which booleans keep.
Box random_box(Random& random, const Box& within, double least, double most) {
  const Vec2 center{random.between(within.min.x, within.max.x), random.between(within.min.y, within.max.y)};
  const Vec2 half{random.between(least, most) / 2, random.between(least, most) / 2};
  return {{std::round(center.x - half.x), std::round(center.y - half.y)},
          {std::round(center.x + half.x), std::round(center.y + half.y)}};
}

}  // namespace

Part wide_part(Random& random, double diameter) {
  const Box block{
      {0, 0}, {std::round(random.between(20, 50) * diameter), std::round(random.between(20, 50) * diameter)}};
  Regions walls;
  for (auto count = 1 + random.below(4); count > 0; --count)
    walls = unite(walls, area_within(random_box(random, block, 2 * diameter, 15 * diameter)), kTol);
  const Regions stock = area_within(block), target = subtract(stock, walls, kTol);
  if (random.below(3) == 0) return part_of(target, target, FeatureKind::kClosedPocket, diameter);
  const Regions air = area_within(block.grown(kOpenReach));
  Part part =
      part_of(target, subtract(air, intersect(stock, walls, kTol), kTol), FeatureKind::kOpenPocket, diameter);
  part.stock = Stock{block, -10, 0};
  return part;
}

}  // namespace clearcut::test_support
