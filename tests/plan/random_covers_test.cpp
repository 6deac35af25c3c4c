// Random faces, blocks and pockets with the strategy cover: every program is proven clean, and planning ends.
#include <gtest/gtest.h>

#include "base/error.h"
#include "geometry/contours/boolean.h"
#include "pipeline/run.h"
#include "support/random/lattice_parts.h"
#include "support/random/random_parts.h"

namespace clearcut {
namespace {

const Tolerances kTol;

Loop rectangle(Vec2 min, Vec2 max) {
  return loop_from_points(std::vector<Vec2>{min, {max.x, min.y}, max, {min.x, max.y}});
}

Loop disc(Vec2 center, double radius) {
  const Vec2 out{radius, 0};
  return Loop{Edge::arc(center - out, center + out, center, Turn::kCounterClockwise),
              Edge::arc(center + out, center - out, center, Turn::kCounterClockwise)};
}

/// A face with free sides all round rows of walls, up to `most` of them; from smaller than the cutter to hundreds of
/// diameters.
Part random_face(Random& random, double diameter, int most) {
  const double size = diameter * std::pow(10, random.between(-1, 1.6));
  const Vec2 max{size, size * random.between(0.1, 1)};
  Regions target{Region::from_valid_loops(rectangle({0, 0}, max), {})};
  Regions walls;
  const double pitch = random.between(1.2, 5) * diameter, wide = random.between(0.1, 0.5) * pitch;
  for (double y = pitch / 2; y < max.y && std::ssize(walls) < most; y += pitch) {
    for (double x = pitch / 2; x < max.x && std::ssize(walls) < most; x += pitch) {
      const Vec2 half{wide / 2, wide * random.between(0.2, 0.5)};
      Loop wall =
          random.below(2) == 0 ? disc({x, y}, wide / 2) : rectangle(Vec2{x, y} - half, Vec2{x, y} + half);
      walls.push_back(Region::from_valid_loops(std::move(wall), {}));
    }
  }
  const Vec2 beside{5 * diameter, 5 * diameter};
  const Regions air{Region::from_valid_loops(rectangle(-beside, max + beside), {})};
  target = subtract(target, walls, kTol);
  if (target.empty()) return {};
  return test_support::part_of(target, subtract(air, walls, kTol), FeatureKind::kOpenPocket, diameter);
}

Part random_part(int kind, Random& random, double diameter) {
  switch (kind) {
    case 0:
      return random_face(random, diameter, 0);
    case 1:
      return random_face(random, diameter, 40);
    case 2:
      return test_support::exact_fit_pocket(random, diameter);
    default:
      return test_support::random_part(random, diameter);
  }
}

TEST(RandomCovers, AreProvenClean) {
  PlanOptions options;
  options.strategy = "cover";
  options.threads = 1;
  options.time_s = 0.02;
  const int wanted = test_support::random_count(16);
  int parts = 0;
  for (int seed = 1; seed <= wanted; ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const double diameter = random.between(2, 8);
    const Part part = random_part(seed % 4, random, diameter);
    if (part.features.empty() || part.features.front().target.empty()) continue;
    const auto result = pipeline::plan_part(part, options);
    ++parts;
    for (const Fault& fault : result.findings.faults) ADD_FAILURE() << fault.text;
  }
  EXPECT_GT(parts, wanted / 2);
}

}  // namespace
}  // namespace clearcut
