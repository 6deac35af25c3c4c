#include "features/round_hole.h"

#include <algorithm>
#include <cmath>

#include "base/tolerances.h"
#include "model/cutter_profile.h"

namespace clearcut::features {

std::optional<RoundHole> round_hole_of(const Feature& feature, const Tolerances& tol) {
  if (!closed_all_round(feature) || feature.wall_slope.radians() != 0 || feature.target.size() != 1)
    return std::nullopt;
  const Region& region = feature.target.front();
  const Edge& first = region.outer().front();
  if (!region.islands().empty() || !first.is_arc()) return std::nullopt;
  RoundHole hole{first.center, first.radius()};
  for (const Edge& edge : region.outer()) {
    if (!edge.is_arc() || edge.turn != first.turn) return std::nullopt;
    if (distance(edge.center, first.center) > tol.join_gap) return std::nullopt;
    if (std::abs(edge.radius() - first.radius()) > tol.join_gap) return std::nullopt;
    hole.radius = std::min(hole.radius, edge.radius());
  }
  return hole;
}

double full_depth(const Part& part, const Workingstep& step) {
  return feature_of(part, step).floor_z + step.operation.allowance_floor + point_length(tool_of(part, step));
}

bool makes_hole(const Tool& tool, const RoundHole& hole, const Tolerances& tol) {
  const double spare = 2 * hole.radius - tool.diameter;
  return spare >= -tol.fit - kSamePlaceMm && spare <= tol.uncut + kSamePlaceMm;
}

bool is_near_size(double drill, double hole) {
  return std::abs(drill - hole) <= kNearDrill + kSamePlaceMm;
}

bool is_shallower_than_point(const Feature& feature, const Tool& tool, const Tolerances& tol) {
  return tool.kind == ToolKind::kDrill &&
         radius_at(tool, feature.top_z - feature.floor_z) < tool.radius() - tol.uncut;
}

bool leaves_hole_undone(const Part& part, const Workingstep& step, const Tolerances& tol) {
  const Tool& tool = tool_of(part, step);
  const Feature& feature = feature_of(part, step);
  if (!makes_holes(tool) || !step.operation.is_tool_chosen) return false;
  const auto hole = round_hole_of(feature, tol);
  if (!hole) return false;
  const bool is_too_narrow = 2 * hole->radius > tool.diameter + tol.uncut + kSamePlaceMm;
  if (!is_too_narrow && !is_shallower_than_point(feature, tool, tol)) return false;
  return std::count_if(part.workplan.begin(), part.workplan.end(),
                       [&](const Workingstep& other) { return other.feature == step.feature; }) == 1;
}

std::vector<PredrilledHole> holes_before(const Part& part, int workingstep, const Tolerances& tol) {
  std::vector<PredrilledHole> holes = part.predrilled;
  const Workingstep& own = part.workplan.at(static_cast<std::size_t>(workingstep));
  const double deep = feature_of(part, own).floor_z + own.operation.allowance_floor;
  const Box here = box(feature_of(part, own).allowed);  // a quick test: most holes are outside of this box
  for (int i = 0; i < workingstep; ++i) {
    const Workingstep& step = part.workplan[static_cast<std::size_t>(i)];
    const Feature& feature = feature_of(part, step);
    const double floor = feature.floor_z + step.operation.allowance_floor;
    if (floor > deep) continue;
    if (is_formed(feature)) continue;  // narrower than its outline, or no deeper than its cone
    const auto hole = round_hole_of(feature, tol);
    if (!hole || !box(feature.target).overlaps(here)) continue;
    const Tool& tool = tool_of(part, step);
    const double milled = hole->radius - step.operation.allowance_side;
    if (tool.radius() > (makes_holes(tool) ? hole->radius : milled) + tol.fit) continue;
    // If the tool's end is rounded or pointed, the hole is narrower at this depth than higher up.
    const double cleared = radius_cleared(tool, deep - floor);
    const double narrower = std::max(0.0, tool.radius() - cleared);
    const double width = (makes_holes(tool) ? tool.diameter : 2 * milled) - 2 * narrower;
    if (cleared > 0 && width > 0) holes.push_back({hole->center, width});
  }
  return holes;
}

}  // namespace clearcut::features
