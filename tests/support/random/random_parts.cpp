#include "support/random/random_parts.h"

#include "base/units.h"
#include "geometry/contours/boolean.h"

namespace clearcut::test_support {
namespace {

const Tolerances kTol;

Region disc(Vec2 center, double radius) {
  const Vec2 east = center + Vec2{radius, 0}, west = center - Vec2{radius, 0};
  return Region::from_valid_loops({Edge::arc(east, west, center, Turn::kCounterClockwise),
                                   Edge::arc(west, east, center, Turn::kCounterClockwise)},
                                  {});
}

Region turned_box(Vec2 center, double width, double height, double angle) {
  std::vector<Vec2> points;
  for (const Vec2 corner : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}}) {
    points.push_back(center + rotated(Vec2{corner.x * width / 2, corner.y * height / 2}, angle));
  }
  return Region::from_valid_loops(loop_from_points(points), {});
}

Region star(Vec2 center, Random& random) {
  const auto count = 3 + random.below(9);
  std::vector<Vec2> points;
  for (std::uint64_t i = 0; i < count; ++i) {
    points.push_back(center + direction_of(2 * kPi * static_cast<double>(i) / static_cast<double>(count)) *
                                  random.between(5, 25));
  }
  return Region::from_valid_loops(loop_from_points(points), {});
}

Region blob(Random& random, double size) {
  const Vec2 center{random.between(-25, 25), random.between(-25, 25)};
  switch (random.below(3)) {
    case 0:
      return disc(center, random.between(0.2, 0.7) * size);
    case 1:
      return turned_box(center, random.between(0.2, 2) * size, random.between(0.2, 1) * size,
                        random.below(2) == 0 ? 0 : random.between(0, kPi));
    default:
      return star(center, random);
  }
}

}  // namespace

Regions random_regions(Random& random) {
  Regions regions{blob(random, 25)};
  for (auto more = random.below(4); more > 0; --more) regions = unite(regions, {blob(random, 25)}, kTol);
  for (auto islands = random.below(4); islands > 0; --islands) {
    regions = subtract(regions, {blob(random, 8)}, kTol);
  }
  return regions;
}

Part part_of(Regions target, Regions allowed, FeatureKind kind, double diameter) {
  Part part;
  part.name = "random";
  Tool tool;
  tool.diameter = diameter;
  part.tools = {tool};
  Feature feature;
  feature.name = "feature";
  feature.kind = kind;
  feature.target = std::move(target);
  feature.allowed = std::move(allowed);
  feature.floor_z = -2;
  part.features = {feature};
  Workingstep step;
  step.operation.stepdown = 2;
  step.operation.entry = EntryKind::kPlunge;
  part.workplan = {step};
  return part;
}

Part random_part(Random& random, double diameter) {
  const Regions regions = random_regions(random);
  if (random.below(3) > 0 || regions.empty()) {
    return part_of(regions, regions, FeatureKind::kClosedPocket, diameter);
  }
  const Box around = box(regions);
  // On whole millimetres, which booleans keep: walls may end on the block's edges.
  Box block = around.grown(random.between(-0.1, 0.4) * around.width());
  block = {{std::floor(block.min.x), std::floor(block.min.y)},
           {std::ceil(block.max.x), std::ceil(block.max.y)}};
  if (block.width() < diameter || block.height() < diameter) {
    return part_of(regions, regions, FeatureKind::kClosedPocket, diameter);
  }
  const Regions stock{turned_box(block.center(), block.width(), block.height(), 0)};
  const Regions air{
      turned_box(block.center(), block.width() + 2 * kOpenReach, block.height() + 2 * kOpenReach, 0)};
  const Regions walls = intersect(stock, regions, kTol);
  Regions target = subtract(stock, walls, kTol);
  // Slivers between walls and the block's edge are nobody's part.
  std::erase_if(target, [](const Region& region) { return region.area() < 0.01 * length(region.outer()); });
  if (target.empty()) return part_of(regions, regions, FeatureKind::kClosedPocket, diameter);
  Part part = part_of(target, subtract(air, walls, kTol), FeatureKind::kOpenPocket, diameter);
  part.stock = Stock{block, -10, 0};
  return part;
}

}  // namespace clearcut::test_support
