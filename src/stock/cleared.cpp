#include "stock/cleared.h"

#include <algorithm>

#include "geometry/boolean.h"

namespace clearcut::stock {
namespace {

/// mm. What is thinner than this in the mean, along outlines that were meant to coincide, does not count.
constexpr double kSliver = 0.05;

}  // namespace

Cleared::Cleared(double floor, Regions cleared)
    : floor_z(floor), area(std::move(cleared)), extent(box(area)) {}

bool is_sliver(const Region& region) {
  double around = length(region.outer());
  for (const Loop& island : region.islands()) around += length(island);
  return region.area() < kSliver * around / 2;
}

bool negligible(const Regions& regions) {
  return std::all_of(regions.begin(), regions.end(), is_sliver);
}

Regions without(const Regions& standing, const Cleared& cleared, const Tolerances& tol) {
  return box(standing).overlaps(cleared.extent) ? subtract(standing, cleared.area, tol) : standing;
}

double top_over(const Regions& target, const std::vector<Cleared>& deepest_first, double start,
                const Tolerances& tol) {
  Regions standing = target;
  for (const Cleared& cleared : deepest_first) {
    standing = without(standing, cleared, tol);
    if (negligible(standing)) return std::min(start, cleared.floor_z);
  }
  return start;
}

}  // namespace clearcut::stock
