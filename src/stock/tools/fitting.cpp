#include "stock/tools/fitting.h"

#include <algorithm>

#include "geometry/boolean.h"
#include "geometry/clearance.h"
#include "stock/at_depth.h"

namespace clearcut::stock {
namespace {

/// Greatest distance of a place in `target` from the boundary of `allowed`, by its medial axis; where that runs
/// beside the target (far open sides), by the middle of the target.
double widest_over(const Regions& target, const Region& allowed, const Tolerances& tol) {
  const Clearance clearance(allowed, tol);
  double widest = 0;
  for (const AxisPoint& p : clearance.axis().points) {
    if (p.clearance > widest && contains(target, p.point)) widest = p.clearance;
  }
  for (const Region& region : target) {
    const Clearance own(region, tol);
    for (const AxisPoint& p : own.centers()) {
      if (allowed.contains(p.point)) widest = std::max(widest, allowed.boundary_distance(p.point));
    }
  }
  return widest;
}

}  // namespace

double largest_fitting_diameter(const Feature& feature, const Tolerances& tol) {
  if (feature.profile && feature.profile->side != ProfileSide::kInside) return 2 * kOpenReach;
  if (feature.profile) return 2 * Clearance(Region::from_valid_loops(feature.profile->line, {}), tol).max();
  const double deep = feature.top_z - feature.floor_z;
  const bool leans = feature.wall_slope.radians() != 0 && deep > 0;
  const Regions allowed = leans ? at_depth(feature.allowed, feature.wall_slope, deep, tol) : feature.allowed;
  const Regions target = leans ? intersect(feature.target, allowed, tol) : feature.target;
  const bool closed = closed_all_round(feature);
  double radius = 0;
  for (const auto& region : allowed) {
    radius = std::max(radius, closed ? Clearance(region, tol).max() : widest_over(target, region, tol));
  }
  return 2 * radius;
}

}  // namespace clearcut::stock
