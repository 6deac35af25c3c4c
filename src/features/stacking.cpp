#include "features/stacking.h"

#include <algorithm>
#include <optional>

#include "base/text/format.h"
#include "features/at_depth.h"
#include "features/cleared.h"

namespace clearcut::features {

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

/// mm over its floor down to which a feature is cleared to its full width: if only drills make the feature, the
/// length of their points.
double left_over_floor(const Part& part, int feature) {
  std::optional<double> left;
  for (const Workingstep& step : part.workplan) {
    const int tool = step.operation.tool;
    // Readers ask before tools are chosen.
    const bool is_known = tool >= 0 && tool < static_cast<int>(part.tools.size());
    if (step.feature != feature) continue;
    const double point = is_known ? point_length(part.tools[static_cast<std::size_t>(tool)]) : 0;
    left = std::min(left.value_or(point), point);
  }
  return left.value_or(0);
}

Cleared cleared_by(const Feature& feature, double floor, double top, const Tolerances& tol) {
  return {floor, at_depth(feature.target, feature.wall_slope, top - feature.floor_z, tol)};
}

/// What an undercut lies below: not the slot for its neck, which goes down as far.
std::vector<Cleared> shallower(std::vector<Cleared> cleared, double floor) {
  constexpr double kSameFloor = 0.01;  // mm
  std::erase_if(cleared, [&](const Cleared& one) { return one.floor_z <= floor + kSameFloor; });
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
    const bool is_undercut = feature.kind == FeatureKind::kTSlot;
    const double over = top_over(
        feature.target, is_undercut ? shallower(deepest_first, feature.floor_z) : deepest_first, start, tol);
    const double top = feature.chamfer ? over : std::max(over, feature.floor_z);
    tops[static_cast<std::size_t>(index)] = top;
    // A chamfer, a countersink, a thread or an undercut does not lower the material for other features.
    if (feature.chamfer || is_formed(feature) || feature.kind == FeatureKind::kTSlot) continue;
    const double full = feature.floor_z + left_over_floor(part, index);
    const auto place = std::upper_bound(deepest_first.begin(), deepest_first.end(), full,
                                        [](double floor, const Cleared& c) { return floor < c.floor_z; });
    deepest_first.insert(place, cleared_by(feature, full, top, tol));
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

}  // namespace clearcut::features
