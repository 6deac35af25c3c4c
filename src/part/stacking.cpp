// Where each feature's material begins, given what was cut before it.
//
// Over a point p of feature f the material stands at the lowest floor of the earlier features that cover p,
// or at the stock's top. The highest such place of f's target is its top. With the earlier features sorted
// deepest first and U_k the union of the first k, it is the floor of the first k for which U_k covers the
// target: so they are subtracted one after the other until nothing is left.
#include <algorithm>

#include "base/format.h"
#include "geometry/boolean.h"
#include "part/part.h"

namespace clearcut {

namespace {

/// mm; what stands thinner than this in the mean, along outlines that were meant to coincide, does not count.
constexpr double kSliver = 0.05;

/// Features in order of their first workingstep.
std::vector<int> cutting_order(const Part& part) {
  std::vector<int> order;
  std::vector<bool> seen(part.features.size(), false);
  for (const Workingstep& step : part.workplan) {
    const auto index = static_cast<std::size_t>(step.feature);
    if (!seen[index]) order.push_back(step.feature);
    seen[index] = true;
  }
  return order;
}

/// Is this no more than slivers along shared outlines?
bool is_sliver(const Region& region) {
  double around = length(region.outer());
  for (const Loop& island : region.islands()) around += length(island);
  return region.area() < kSliver * around / 2;
}

bool negligible(const Regions& regions) {
  return std::all_of(regions.begin(), regions.end(), is_sliver);
}

/// What an earlier feature has cleared down to its floor.
struct Cleared {
  double floor_z = 0;
  Regions area;
  Box extent;
};

Regions subtract_where_near(const Regions& regions, const Cleared& cleared, const Tolerances& tol) {
  return box(regions).overlaps(cleared.extent) ? subtract(regions, cleared.area, tol) : regions;
}

double top_of(const Feature& feature, const std::vector<Cleared>& deepest_first, double start,
              const Tolerances& tol) {
  Regions standing = feature.target;
  for (const Cleared& cleared : deepest_first) {
    standing = subtract_where_near(standing, cleared, tol);
    if (negligible(standing)) return std::min(start, cleared.floor_z);
  }
  return start;
}

Cleared cleared_by(const Feature& feature, double top, const Tolerances& tol) {
  Cleared cleared{
      feature.floor_z, at_depth(feature.target, feature.wall_slope, top - feature.floor_z, tol), {}};
  cleared.extent = box(cleared.area);
  return cleared;
}

}  // namespace

std::vector<double> stacked_tops(const Part& part, const Tolerances& tol) {
  std::vector<double> tops;
  for (const Feature& feature : part.features) tops.push_back(feature.top_z);
  std::vector<Cleared> deepest_first;
  for (const int index : cutting_order(part)) {
    const Feature& feature = part.features[static_cast<std::size_t>(index)];
    const double start = part.stock ? part.stock->z_top : feature.top_z;
    const double top = std::max(top_of(feature, deepest_first, start, tol), feature.floor_z);
    tops[static_cast<std::size_t>(index)] = top;
    const auto place = std::upper_bound(deepest_first.begin(), deepest_first.end(), feature.floor_z,
                                        [](double floor, const Cleared& c) { return floor < c.floor_z; });
    deepest_first.insert(place, cleared_by(feature, top, tol));
  }
  return tops;
}

Regions standing_target(const Part& part, int feature, double z, const Tolerances& tol) {
  const Feature& wanted = part.features[static_cast<std::size_t>(feature)];
  Regions standing = wanted.target;
  for (const int index : cutting_order(part)) {
    if (index == feature) break;
    const Feature& earlier = part.features[static_cast<std::size_t>(index)];
    if (earlier.floor_z > z + tol.coincident) continue;
    standing = subtract_where_near(standing, cleared_by(earlier, earlier.top_z, tol), tol);
  }
  std::erase_if(standing, is_sliver);
  return standing;
}

void stack_tops(Part& part, const Tolerances& tol) {
  const std::vector<double> tops = stacked_tops(part, tol);
  for (std::size_t i = 0; i < tops.size(); ++i) {
    Feature& feature = part.features[i];
    const double declared = feature.top_z;
    feature.top_z = tops[i];
    const std::string where = feature.name + (feature.source.empty() ? "" : " (" + feature.source + ")");
    const std::string heights = "its top is given as z " + trimmed(declared, 3) +
                                ", but what is cut before it leaves material up to z " + trimmed(tops[i], 3);
    if (tops[i] > declared + tol.join_gap)
      part.diagnostics.warn(where, heights + "; it is cut from there");
    else if (tops[i] < declared - tol.join_gap)
      part.diagnostics.note(where, heights + " only; it is cut from there");
  }
}

}  // namespace clearcut
