#include "studies/random_polygon.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/elementary.h"
#include "base/units.h"
#include "geometry/contours/boolean.h"
#include "geometry/side_list.h"
#include "geometry/voronoi/clearance.h"

namespace clearcut::studies {
namespace {

constexpr double kSmallestAngle = 8 * kPi / 180;
constexpr double kLargestAcute = 30 * kPi / 180;
constexpr double kDepth = 2;
constexpr std::array kKinds{"convex", "acute", "concave", "arcs", "islands"};

using Corners = std::vector<Vec2>;

Vec2 direction(double angle) {
  return {base::cos(angle), base::sin(angle)};
}

std::vector<double> sorted_angles(Random& random, std::size_t count) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < count; ++i) angles.push_back(random.between(0, 2 * kPi));
  std::sort(angles.begin(), angles.end());
  return angles;
}

Corners convex(Random& random) {
  const double a = random.between(20, 80), b = random.between(20, 80);
  Corners corners;
  for (const double angle : sorted_angles(random, 3 + random.below(9))) {
    corners.push_back({a * base::cos(angle), b * base::sin(angle)});
  }
  return corners;
}

/// A wedge of one sharp angle, closed by a few more corners.
Corners acute(Random& random) {
  const double angle = random.between(kSmallestAngle, kLargestAcute), reach = random.between(60, 140);
  Corners corners{{0, 0}};
  const std::size_t count = 2 + random.below(4);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    const double bulge = 1 + random.between(0, 0.25) * base::sin(kPi * share);
    corners.push_back(direction(share * angle) * (reach * bulge));
  }
  return corners;
}

Corners concave(Random& random) {
  const auto count = 4 + random.below(9);
  Corners corners;
  for (std::uint64_t i = 0; i < count; ++i) {
    const double angle =
        2 * kPi * (static_cast<double>(i) + random.between(0.15, 0.85)) / static_cast<double>(count);
    corners.push_back(direction(angle) * random.between(20, 80));
  }
  return corners;
}

SideList sides_of(const Corners& corners) {
  const Loop loop = loop_from_points(corners);
  SideList list;
  list.start = corners.front();
  const Vec2 along = loop.front().tangent_at(0);
  list.orientation = base::atan2(along.y, along.x);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 in = loop[i].tangent_at(1), out = loop[(i + 1) % loop.size()].tangent_at(0);
    list.sides.push_back({loop[i].length(), kPi - base::atan2(cross(in, out), dot(in, out)), 0});
  }
  return list;
}

bool sharp_enough_to_mill(const SideList& list) {
  return std::all_of(list.sides.begin(), list.sides.end(), [](const Side& side) {
    return side.angle >= kSmallestAngle && side.angle <= 2 * kPi - kSmallestAngle && side.length > 1;
  });
}

/// Rounds most corners by arcs that leave some of every side straight.
Loop rounded(SideList list, Random& random) {
  const std::size_t n = list.sides.size();
  const SideList sharp = list;
  for (std::size_t i = 0; i < n; ++i) {
    Side& corner = list.sides[i];
    if (random.below(4) == 0) continue;
    const double room = 0.45 * std::min(sharp.sides[i].length, sharp.sides[(i + 1) % n].length);
    corner.radius = 1;
    corner.radius = std::min(random.between(1, 20), room / tangent_length(corner));
  }
  for (std::size_t i = 0; i < n; ++i) {
    list.sides[i].length -= tangent_length(list.sides[i]) + tangent_length(list.sides[(i + n - 1) % n]);
  }
  list.start = list.start + direction(list.orientation) * tangent_length(list.sides.back());
  return closed_by_compass_rule(traced(list));
}

Region island(Vec2 center, Random& random) {
  const double size = random.between(2, 10);
  if (random.below(2) == 0) {
    const Vec2 east = center + Vec2{size, 0}, west = center - Vec2{size, 0};
    return Region::from_valid_loops({Edge::arc(east, west, center, Turn::kCounterClockwise),
                                     Edge::arc(west, east, center, Turn::kCounterClockwise)},
                                    {});
  }
  const Vec2 half = direction(random.between(0, kPi)) * size,
             across = Vec2{-half.y, half.x} * random.between(0.3, 1);
  return Region::from_valid_loops(loop_from_points(Corners{center - half - across, center + half - across,
                                                           center + half + across, center - half + across}),
                                  {});
}

Regions with_islands(Regions regions, Random& random, const Tolerances& tol) {
  const Box around = box(regions);
  for (auto more = 1 + random.below(3); more > 0; --more) {
    const Vec2 center{random.between(around.min.x, around.max.x), random.between(around.min.y, around.max.y)};
    if (contains(regions, center)) regions = subtract(regions, {island(center, random)}, tol);
  }
  return regions;
}

/// Empty where the draw is no good: another is made.
Regions drawn(const std::string& kind, Random& random, const Tolerances& tol) {
  const Corners corners = kind == "convex"    ? convex(random)
                          : kind == "acute"   ? acute(random)
                          : random.below(2)   ? concave(random)
                          : kind == "concave" ? concave(random)
                                              : convex(random);
  const SideList list = sides_of(corners);
  if (!sharp_enough_to_mill(list) || signed_area(loop_from_points(corners)) < 200) return {};
  Loop loop = kind == "arcs" ? rounded(list, random) : loop_from_points(corners);
  Regions regions{Region::from_valid_loops(std::move(loop), {})};
  return kind == "islands" ? with_islands(std::move(regions), random, tol) : regions;
}

Part part_of(const Regions& regions, double diameter) {
  Part part;
  Tool tool;
  tool.diameter = diameter;
  part.tools = {tool};
  Feature feature;
  feature.name = "pocket";
  feature.target = feature.allowed = regions;
  feature.floor_z = -kDepth;
  part.features = {feature};
  Workingstep step;
  step.operation.stepdown = kDepth;
  step.operation.entry = EntryKind::kPlunge;
  part.workplan = {step};
  return part;
}

}  // namespace

RandomPocket random_pocket(std::uint64_t seed, const Tolerances& tol) {
  Random random(seed);
  RandomPocket pocket;
  pocket.kind = kKinds[seed % kKinds.size()];
  Regions regions;
  while (regions.empty()) regions = drawn(pocket.kind, random, tol);
  double widest = 0;
  for (const auto& region : regions) widest = std::max(widest, 2 * Clearance(region, tol).max());
  const double diameter = std::max(1.0, std::round(random.between(0.08, 0.6) * widest * 10) / 10);
  pocket.part = part_of(regions, diameter);
  pocket.part.name = pocket.kind + " " + std::to_string(seed);
  return pocket;
}

}  // namespace clearcut::studies
