#include "features/cleared.h"

#include <algorithm>

#include "geometry/contours/boolean.h"

namespace clearcut::features {
namespace {

/// mm. Remainders with a smaller mean thickness, along nominally coincident outlines, do not count.
constexpr double kSliver = 0.05;
/// Share of a target's own width from which on a remainder counts.
constexpr double kShareOfOwn = 0.5;

/// mm.
double mean_width(const Region& region) {
  double around = length(region.outer());
  for (const Loop& island : region.islands()) around += length(island);
  return 2 * region.area() / around;
}

}  // namespace

Cleared::Cleared(double floor, Regions cleared)
    : floor_z(floor), area(std::move(cleared)), extent(box(area)) {}

double sliver_width(const Regions& target) {
  double width = kSliver;
  for (const Region& region : target) width = std::min(width, kShareOfOwn * mean_width(region));
  return width;
}

bool is_sliver(const Region& region, double width) {
  return mean_width(region) < width;
}

Regions without(const Regions& standing, const Cleared& cleared, const Tolerances& tol) {
  return box(standing).overlaps(cleared.extent) ? subtract(standing, cleared.area, tol) : standing;
}

double top_over(const Regions& target, const std::vector<Cleared>& deepest_first, double start,
                const Tolerances& tol) {
  Regions standing = target;
  const double width = sliver_width(target);
  for (const Cleared& cleared : deepest_first) {
    standing = without(standing, cleared, tol);
    const bool is_gone = std::all_of(standing.begin(), standing.end(),
                                     [&](const Region& region) { return is_sliver(region, width); });
    if (is_gone) return std::min(start, cleared.floor_z);
  }
  return start;
}

}  // namespace clearcut::features
