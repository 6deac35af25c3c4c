#include "features/standing.h"

#include <algorithm>
#include <optional>

#include "base/text.h"
#include "features/derived_outlines.h"
#include "features/round_hole.h"
#include "geometry/contours/boolean.h"
#include "geometry/spatial/apart.h"
#include "geometry/voronoi/clearance.h"

namespace clearcut::features {
namespace {

/// mm. Remainders with a smaller mean thickness, along nominally coincident outlines, do not count.
constexpr double kSliver = 0.05;
/// mm. Room that the tool above its flutes needs beside it, more than slivers are thick.
constexpr double kClearOfShank = 0.2;
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

namespace {

/// By how much, as a multiple of the step's stock, a target reaches into that stock beyond the area to be cleared:
/// planners expect targets that end at walls or in fully cut areas.
constexpr double kIntoStock = 1.5;

/// mm. The least stock to leave of all steps of one feature so far.
struct StockLeft {
  std::optional<double> side;
  std::optional<double> floor;

  void add(const Operation& operation, const Tool& tool) {
    side = std::min(side.value_or(operation.allowance_side), operation.allowance_side);
    // If something was cleared before, finishing of walls does not reach the floor.
    if (operation.kind == OperationKind::kSideFinishing && floor) return;
    // a drill leaves the cone of its point
    const double left = operation.allowance_floor + point_length(tool);
    floor = std::min(floor.value_or(left), left);
  }
};

/// Whether the step clears its feature's target; a drill clears only a hole of its own size, and over an undercut
/// there is material.
bool clears(const Part& part, const Workingstep& step, const Tolerances& tol) {
  if (feature_of(part, step).kind == FeatureKind::kTSlot) return false;
  if (!makes_holes(tool_of(part, step))) return true;
  const auto hole = round_hole_of(feature_of(part, step), tol);
  return hole && makes_hole(tool_of(part, step), *hole, tol);
}

/// `regions` without the strip within `distance` mm of the walls, which bound `allowed`.
Regions off_the_walls(const Regions& regions, const Regions& allowed, double distance,
                      const Tolerances& tol) {
  if (distance <= 0) return regions;
  return intersect(regions, inset(allowed, distance, tol), tol);
}

Cleared cleared_by(const Feature& feature, const StockLeft& stock, const Tolerances& tol) {
  const double deep = feature.top_z - feature.floor_z;
  const Regions target = at_depth(feature.target, feature.wall_slope, deep, tol);
  const double side = stock.side.value_or(0);
  if (side <= 0) return {feature.floor_z + stock.floor.value_or(0), target};
  const Regions allowed = at_depth(feature.allowed, feature.wall_slope, deep, tol);
  return {feature.floor_z + stock.floor.value_or(0), off_the_walls(target, allowed, side, tol)};
}

void sort_deepest_first(std::vector<Cleared>& areas) {
  std::stable_sort(areas.begin(), areas.end(),
                   [](const Cleared& a, const Cleared& b) { return a.floor_z < b.floor_z; });
}

void erase_slivers(Regions& regions, double width) {
  std::erase_if(regions, [&](const Region& region) { return is_sliver(region, width); });
}

}  // namespace

Standing::Standing(const Part& part, int workingstep, const Tolerances& tol, const ClearsAll& clears_all)
    : feature_(feature_of(part, part.workplan.at(static_cast<std::size_t>(workingstep)))),
      stock_(part.workplan[static_cast<std::size_t>(workingstep)].operation.allowance_side),
      tol_(tol),
      start_(feature_.top_z) {
  if (part.stock) block_ = part.stock->plan;
  std::vector<StockLeft> stock(part.features.size());
  const Box here = box(feature_.target);
  for (int i = 0; i < workingstep; ++i) {
    const Workingstep& step = part.workplan[static_cast<std::size_t>(i)];
    if (clears_all && !clears_all(i)) {
      const Feature& other = feature_of(part, step);
      if (&other == &feature_ || are_apart(other.target, feature_.target, 2 * tol.chord)) continue;
      uncertain_ = true;
      start_ = std::max(start_, other.top_z);
    } else if (clears(part, step, tol)) {
      stock[static_cast<std::size_t>(step.feature)].add(step.operation, tool_of(part, step));
    }
  }
  for (std::size_t i = 0; i < part.features.size(); ++i) {
    const Feature& other = part.features[i];
    if (&other == &feature_ || !stock[i].side || !box(other.target).overlaps(here)) continue;
    start_ = std::max(start_, other.top_z);
    stock_left_ = stock_left_ || *stock[i].side > 0 || stock[i].floor.value_or(0) > 0;
    // If the targets are apart, only the height counts and no area.
    if (are_apart(other.target, feature_.target, 2 * tol.chord)) {
      by_work_.push_back({other.floor_z + stock[i].floor.value_or(0), {}});
      continue;
    }
    by_design_.push_back(cleared_by(other, {}, tol));
    by_work_.push_back(cleared_by(other, stock[i], tol));
  }
  sort_deepest_first(by_design_);
  sort_deepest_first(by_work_);
}

double Standing::top() const {
  if (uncertain_) return std::max(top_over(wanted(feature_.target), by_work_, start_, tol_), feature_.top_z);
  if (!stock_left_) return feature_.top_z;
  const Regions target = in_block();
  const double left = top_over(wanted(target), by_work_, start_, tol_);
  const double designed = top_over(target, by_design_, start_, tol_);
  return left > designed ? std::max(left, feature_.top_z) : feature_.top_z;
}

Regions Standing::in_block() const {
  const Box target = box(feature_.target);
  if (!block_ || (block_->contains(target.min) && block_->contains(target.max))) return feature_.target;
  Regions inside = intersect(feature_.target, {rectangular_region(*block_)}, tol_);
  return inside.empty() ? feature_.target : inside;
}

Regions Standing::above(double z) const {
  Regions standing = feature_.target;
  bool whole = true;
  for (const Cleared& cleared : by_work_) {
    if (cleared.floor_z > z + tol_.coincident) break;
    standing = without(standing, cleared, tol_);
    whole = false;
  }
  const double width = sliver_width(feature_.target);
  erase_slivers(standing, width);
  if (whole || stock_ <= 0 || standing.empty()) return standing;
  Regions asked = wanted(standing);
  erase_slivers(asked, width);
  if (asked.empty()) return asked;
  return intersect(standing, dilate(asked, kIntoStock * stock_, tol_), tol_);
}

Regions Standing::wanted(const Regions& regions) const {
  return off_the_walls(regions, feature_.allowed, stock_, tol_);
}

bool is_cone(const Feature& feature) {
  return feature.hole &&
         (feature.hole->kind == HoleKind::kSpotted || feature.hole->kind == HoleKind::kCountersunk);
}

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
    const double top = feature.chamfer || is_cone(feature) ? over : std::max(over, feature.floor_z);
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

double top_beside_tool(const Part& part, std::size_t steps, const Regions& target, const Tool& tool,
                       const Tolerances& tol) {
  Part before = part;
  before.workplan.resize(steps);
  Workingstep asked;
  asked.feature = static_cast<int>(before.features.size());
  asked.operation.tool = -1;
  Feature place;
  const double wider = std::max(0.0, tool.shank_diameter / 2 - widest_radius(tool));
  place.target = dilate(target, wider + kClearOfShank, tol);
  place.top_z = place.floor_z = part.top_z();
  for (const Feature& feature : part.features) place.floor_z = std::min(place.floor_z, feature.floor_z);
  before.features.push_back(place);
  before.workplan.push_back(asked);
  return stacked_tops(before, tol).back();
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
