#include "stock/stacking.h"

#include <algorithm>

#include "base/text/format.h"
#include "stock/at_depth.h"
#include "stock/cleared.h"

namespace clearcut::stock {

namespace {

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

Cleared cleared_by(const Feature& feature, double top, const Tolerances& tol) {
  return {feature.floor_z, at_depth(feature.target, feature.wall_slope, top - feature.floor_z, tol)};
}

}  // namespace

std::vector<double> stacked_tops(const Part& part, const Tolerances& tol) {
  std::vector<double> tops;
  for (const Feature& feature : part.features) tops.push_back(feature.top_z);
  std::vector<Cleared> deepest_first;
  for (const int index : cutting_order(part)) {
    const Feature& feature = part.features[static_cast<std::size_t>(index)];
    const double start = part.stock ? part.stock->z_top : feature.top_z;
    const double over = top_over(feature.target, deepest_first, start, tol);
    const double top = feature.chamfer ? over : std::max(over, feature.floor_z);
    tops[static_cast<std::size_t>(index)] = top;
    // What a chamfer, a countersink, a thread or an undercut removes does not lower the material for other features.
    if (feature.chamfer || is_formed(feature) || feature.kind == FeatureKind::kTSlot) continue;
    const auto place = std::upper_bound(deepest_first.begin(), deepest_first.end(), feature.floor_z,
                                        [](double floor, const Cleared& c) { return floor < c.floor_z; });
    deepest_first.insert(place, cleared_by(feature, top, tol));
  }
  return tops;
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

}  // namespace clearcut::stock
